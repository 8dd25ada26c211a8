# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension zip: staged, built and validated with Blender's extension command, and installed as by a user."""

import filecmp
import hashlib
import os
import shutil
import tomllib
from pathlib import Path

from . import build
from .target import PROJECT, StepFailed, tail

ID = "fovea"
_unwanted = shutil.ignore_patterns("__pycache__", "*.pyc", "*.pyi", ".*")


def stage(target):
    """Stages the package in WORK/package/fovea: the add-on, with shaders, native module and license beside __init__.py;
    type stubs are left out. An identical staged package is not touched, as running tests may read it. Returns the
    folder."""
    sources = _sources(build.module(target))
    folder = target.work / "package" / ID
    fresh = folder.with_name("fresh")
    with target.lock():
        if not _is_staged(folder, sources):
            shutil.rmtree(fresh, ignore_errors=True)
            for name, source in sources.items():
                (fresh / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(source, fresh / name)
            shutil.rmtree(folder, ignore_errors=True)
            fresh.rename(folder)
    return folder


def _sources(module):
    """{name in the package: file}."""
    found = {file.name: file for file in (module, PROJECT / "LICENSE")}
    for folder, above in ((PROJECT / "addon", "."), (PROJECT / "shaders", "shaders")):
        for place, folders, names in os.walk(folder):
            unwanted = _unwanted(place, [*folders, *names])
            folders[:] = set(folders) - unwanted
            files = (Path(place, name) for name in set(names) - unwanted)
            found |= {os.path.normpath(Path(above, file.relative_to(folder))): file for file in files}
    return found


def _is_staged(folder, sources):
    """Whether a folder has these files and no others; files of one size and time are taken to be one."""
    names = {str(file.relative_to(folder)) for file in _files(folder)}
    return names == set(sources) and all(filecmp.cmp(file, folder / name) for name, file in sources.items())


def importable(target):
    """A folder for sys.path from which plain Python imports the staged package as `addon`."""
    folder = target.work / "importable"
    folder.mkdir(exist_ok=True)
    link = folder / "addon"
    if not link.is_symlink():
        link.symlink_to(target.work / "package" / ID)
    return folder


def package(target, folder=None):
    """The validated zip of the staged package; reused if it was built from identical files and is as it was built."""
    folder = folder or stage(target)
    manifest = tomllib.loads((folder / "blender_manifest.toml").read_text(encoding="utf-8"))
    archive = target.work / "package" / f"{ID}-{manifest['version']}.zip"
    stamp, fresh = target.work / "packaged", archive.with_name("fresh.zip")
    with target.lock():
        content = _content(folder)
        if not (archive.is_file() and stamp.exists() and stamp.read_text() == f"{content} {_digest(archive)}"):
            fresh.unlink(missing_ok=True)
            _remove_damaged(target, content)
            extension(target, "packaging", "build", "--source-dir", folder, "--output-filepath", fresh)
            extension(target, "validating the package", "validate", fresh)
            fresh.replace(archive)
            stamp.write_text(f"{content} {_digest(archive)}")
    return archive


def install(target):
    """Installs and enables the package, unless identical files are installed already. Several parts of the tests may
    ask for it at once: it is installed once, as another time would replace the module under a Blender that runs."""
    folder = stage(target)
    content = _content(folder)
    stamp = target.work / "installed"

    def installed():
        return stamp.exists() and stamp.read_text() == _installation(target, content) and _is_installed(target, content)

    with target.lock():  # not while another part installs it
        _remove_damaged(target, content)
    if installed():
        return
    archive = package(target, folder)
    with target.lock():
        if installed():  # by another part, meanwhile
            return
        log = extension(target, "installing", "install-file", "-r", "user_default", "--enable", archive)
        if not _is_installed(target, content):
            raise StepFailed(f"Blender did not install the extension; the last lines of {log}:\n{tail(log, 25)}")
        stamp.write_text(_installation(target, content))


def extension(target, sentence, *words):
    return target.run(sentence, [target.blender, "--command", "extension", *words])


def _is_installed(target, content):
    """Whether a package of this content (digest) is installed in the target's home."""
    return any(_content(folder) == content for folder in _installed_folders(target))


def _installed_folders(target):
    """Where the extension is installed in the target's home: a folder for each version of Blender."""
    return [place for place in target.home.glob(f".config/blender/*/extensions/user_default/{ID}") if place.is_dir()]


def _remove_damaged(target, content):
    """Removes what is installed of other content: a Blender that starts loads what is enabled, and ends where its
    module is damaged. Of the same content, what Python has compiled: it is loaded instead, and nothing tells whether it
    is damaged."""
    for folder in _installed_folders(target):
        if _content(folder) != content:
            shutil.rmtree(folder)
        else:
            for file in folder.rglob("*.pyc"):
                file.unlink()


def _installation(target, content):
    """What an installation consists of besides its files: the package's digest, the Blender, as another version has its
    extensions in another folder, and the preferences, which enable it."""
    blender = os.stat(shutil.which(target.blender) or target.blender)
    preferences = sorted(target.home.glob(".config/blender/*/config/userpref.blend"))
    digests = [_digest(file) for file in preferences]
    return " ".join([content, str(blender.st_size), str(blender.st_mtime_ns), *digests])


def _content(folder):
    """Digest of names and bytes of all files in a folder, except Python's compiled files."""
    digest = hashlib.sha256()
    for file in sorted(_files(folder)):
        digest.update(f"{file.relative_to(folder)}\0".encode())
        digest.update(f"{_digest(file)}\n".encode())
    return digest.hexdigest()


def _files(folder):
    return [path for path in folder.rglob("*") if path.is_file() and path.suffix != ".pyc"]


def _digest(file):
    return hashlib.sha256(file.read_bytes()).hexdigest()
