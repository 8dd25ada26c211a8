# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea package --all`: a zip for each platform of blender.org's Blenders, with wheels for their Pythons, and the
folder of a repository that Blender can subscribe to; beside them the zip for Debian's Blenders."""

import json
import re
import shutil
import tomllib

from . import package
from .standalone import archive, build, sources, toolchain, wheel
from .target import PROJECT, StepFailed

COMMENT = "# The native modules are in wheels: one for a platform and a Python, of which Blender takes what fits.\n"


def write(target, platforms):
    """Builds packages for platforms (names) from the modules in the cache; returns their folder: the zip for Debian's
    Blenders, and `repository` with the others and index.json."""
    debian = package.package(target)
    folder = target.work / "packages"
    staged = stage(target.work / "package" / "platforms", target.cache / "standalone", platforms)
    with target.lock():
        shutil.rmtree(folder, ignore_errors=True)
        repository = folder / "repository"
        repository.mkdir(parents=True)
        words = ("build", "--split-platforms", "--source-dir", staged, "--output-dir", repository)
        package.extension(target, "packaging for all platforms", *words)
        for zipped in sorted(repository.glob("*.zip")):
            archive.normalize(zipped)
            package.extension(target, f"validating {zipped.name}", "validate", zipped)
        package.extension(target, "listing the repository", "server-generate", "--repo-dir", repository)
        shutil.copyfile(debian, folder / f"{debian.stem}-debian_{target.name}.zip")
        archive.normalize(folder / f"{debian.stem}-debian_{target.name}.zip")
    return folder


def stage(folder, cache, wanted):
    """Stages the add-on with the wheels of platforms, without a module beside it; returns the folder. cache: that of
    modules."""
    unwanted = shutil.ignore_patterns("__pycache__", "*.pyc", "*.pyi", ".*")
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(PROJECT / "addon", folder, ignore=unwanted)
    shutil.copytree(PROJECT / "shaders", folder / "shaders", ignore=unwanted)
    shutil.copy2(PROJECT / "LICENSE", folder)
    manifest = folder / "blender_manifest.toml"
    text = manifest.read_text(encoding="utf-8")
    version = tomllib.loads(text)["version"]
    (folder / "wheels").mkdir()
    unpacked = sources.unpacked(cache)
    names, platforms = [], []
    for platform, python, module in built(cache, wanted):
        licenses = wheel.licenses(unpacked, PROJECT / "LICENSE", platform)
        names.append(wheel.write(folder / "wheels", module, platform, python, version, licenses).name)
        platforms += [platform.name] if platform.name not in platforms else []
    manifest.write_text(with_wheels(text, platforms, names), encoding="utf-8")
    return folder


def built(cache, wanted):
    """(platform, Python, module) of all modules of platforms. StepFailed if one is not built."""
    every = [(toolchain.PLATFORMS[name], python) for name in wanted for python in toolchain.PYTHONS]
    places = [(platform, python, build.module_place(cache, platform, python)) for platform, python in every]
    lacking = [f"{platform.name}-{build.tag(python)}" for platform, python, place in places if not place.is_file()]
    if lacking:
        raise StepFailed(f"not built yet: {', '.join(lacking)}; blender_scripts/fovea standalone {' '.join(lacking)}")
    return places


def with_wheels(manifest, platforms, names):
    """The text of the manifest for these platforms and wheels."""
    lines = [f"platforms = {json.dumps(platforms)}", "wheels = ["]
    lines += [f'    "./wheels/{name}",' for name in names] + ["]"]
    pattern = r"(#[^\n]*\n)?platforms = .*"
    if len(re.findall(pattern, manifest)) != 1:
        raise ValueError("blender_manifest.toml is to have one line of platforms")
    return re.sub(pattern, lambda _: COMMENT + "\n".join(lines), manifest)
