# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds modules, and programs, for a platform: one CMake build for both Pythons, as only the bindings differ."""

import os
import shutil

from .. import module_sources
from ..precompiled import forget_changed
from ..target import PROJECT, StepFailed
from . import linker, python_names, sources, toolchain


def modules(target, platform, pythons=toolchain.PYTHONS):
    """Builds the modules for some Pythons; returns where each is: in the cache, at a place that is always the same."""
    digest = module_sources.digest()  # of what is built now: it may change meanwhile
    built = _build(target, platform, [f"_native_{tag(python)}" for python in pythons])
    places = []
    for python in pythons:
        (found,) = (built / tag(python)).glob("_native.*")
        place = module_place(target.cache, platform, python)
        place.parent.mkdir(parents=True, exist_ok=True)
        fresh = place.with_name("fresh")
        shutil.copyfile(found, fresh)  # a new file: the old one may be loaded
        fresh.replace(place)
        module_sources.record(place).write_text(digest, encoding="utf-8")
        places.append(place)
    return places


def module_place(cache, platform, python):
    return cache / "modules" / f"{platform.name}-{tag(python)}" / platform.module_name(python)


def tag(python):
    """cp311, of 3.11."""
    return f"cp{python.replace('.', '')}"


def names_of_python(target, platform, python):
    """Name -> whether it is data: what a Python has for modules, by its headers on this platform."""
    own = suites_headers(target)
    headers = own.get(python, sources.unpacked(target.cache) / f"python{python}")
    include = [target.work / platform.name / tag(python) / "include", headers / "Include"]
    return python_names.declared(target.work / "compilers" / platform.name / "cc", include)


def suites_headers(target):
    """Python -> the folder of its `Include`, of those of Debian suites that are set up. Copies, without the suite's
    pyconfig.h, which its other headers would take before any other."""
    found = {}
    for python, suite in toolchain.SUITES.items():
        headers = target.cache.parent / suite / "root" / "usr" / "include" / f"python{python}"
        found[python] = target.work / "headers" / f"python{python}"
        if not (headers / "Python.h").exists():
            del found[python]
        elif not (found[python] / "Include").exists():
            fresh = found[python] / "fresh"
            shutil.rmtree(fresh, ignore_errors=True)
            shutil.copytree(headers, fresh, ignore=shutil.ignore_patterns("pyconfig.h"))
            fresh.rename(found[python] / "Include")
    return found


def import_library(target, platform, python):
    """Windows' library by which a module asks for Python's names, made of the headers where there is none yet."""
    found = names_of_python(target, platform, python)
    library = target.work / platform.name / tag(python) / f"libpython{tag(python).removeprefix('cp')}.a"
    dll = f"python{tag(python).removeprefix('cp')}.dll"
    text = python_names.definition(dll, found)
    told = library.with_suffix(".def")
    if not (library.exists() and told.exists() and told.read_text() == text):
        told.write_text(text)
        dlltool = target.work / "compilers" / platform.name / "dlltool"
        words = [dlltool, "-m", "i386:x86-64", "-d", told, "-l", library, "-D", dll]
        target.run(f"making the import library of {dll}", words)


def program(target, platform, name):
    """Builds a program (fovea_tests, fovea_tool); returns it."""
    _build(target, platform, [name])
    return program_place(target, platform, name)


def program_place(target, platform, name):
    return target.work / platform.name / f"{name}{platform.program}"


def _build(target, platform, goals):
    """Builds CMake targets for a platform; returns the build folder."""
    for tool, package in (("cmake", "cmake"), ("ninja", "ninja-build")):
        if not shutil.which(tool):
            raise StepFailed(f"{tool} is missing, with which modules are built: install it (apt-get install {package})")
    folder = target.work / platform.name
    with target.lock():
        source = sources.unpacked(target.cache)
        tools = toolchain.wrappers(target.work / "compilers", source, target.cache / "zig", platform)
        own = suites_headers(target) if platform.system == "Linux" else {}
        options = [*tools, *_options(platform, source, (*toolchain.PYTHONS, *own))]
        options += [f"-DFOVEA_PYTHON_HEADERS={target.work / 'headers'}"] if own else []
        if platform.name in linker.PLATFORMS:
            options.append(linker.option(target, source, platform))
        _configure(target, platform, folder, options)
        if platform.system == "Windows":
            for python in toolchain.PYTHONS:
                import_library(target, platform, python)
        forget_changed(folder)
        jobs = str(len(os.sched_getaffinity(0)))
        step = f"building {' and '.join(goals)} for {platform.name}"
        target.run(step, ["cmake", "--build", folder, "-j", jobs, "--target", *goals], **_caching(target))
    return folder


def _options(platform, source, pythons):
    options = ["-G", "Ninja", *platform.cmake_options, f"-DFOVEA_SOURCES={source}"]
    options += ["-DCMAKE_BUILD_TYPE=Release", f"-DFOVEA_PYTHONS={';'.join(pythons)}"]
    if shutil.which("ccache"):
        options += [f"-DCMAKE_{language}_COMPILER_LAUNCHER=ccache" for language in ("C", "CXX")]
    return options


def _configure(target, platform, folder, options):
    """CMake's configure step, if the options changed."""
    record = folder / "configured-with"
    if (folder / "build.ninja").exists() and record.exists() and record.read_text() == "\n".join(options):
        return
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    link = target.work / "source"
    if not link.is_symlink():
        link.symlink_to(PROJECT)  # paths relative to it let ccache share objects between clones
    step = f"configuring the build for {platform.name}"
    target.run(step, ["cmake", "-S", link, "-B", folder, *options], **_caching(target))
    record.write_text("\n".join(options))


def _caching(target):
    """Settings of ccache: what wrappers say tells compilers apart, and paths are relative to all that is built here."""
    return {
        "CCACHE_DIR": str(target.cache.parent / "ccache"), "CCACHE_BASEDIR": str(target.cache),
        "CCACHE_COMPILERCHECK": "content", "CCACHE_COMPILERTYPE": "clang",
        "CCACHE_DEPEND": "1",
    }  # fmt: skip
