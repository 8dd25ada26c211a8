# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-contained modules: what they take from the system, and from the Blender that loads them. Modules that are not in
the cache are not tested; `fovea standalone` builds them."""

import os
import sys
import zlib
from pathlib import Path

import pytest
from command.standalone import bindings, build, checks, interface, toolchain

from addon import native as loader

PROJECT = Path(__file__).parents[2]
BLENDER = os.environ.get("FOVEA_BLENDER")
CACHE = Path(os.environ.get("FOVEA_STANDALONE", "nowhere"))
LINUX, WINDOWS, MACOS = (toolchain.PLATFORMS[name] for name in ("linux-x64", "windows-x64", "macos-arm64"))
COPYING = {"memcpy": "GLIBC_2.14", "memmove": "GLIBC_2.2.5", "memset": "GLIBC_2.2.5"}
MODULES = [
    pytest.param(platform, python, id=f"{platform.name}-{build.tag(python)}")
    for platform in toolchain.PLATFORMS.values()
    for python in toolchain.PYTHONS
]


def module(platform, python):
    place = build.module_place(CACHE, platform, python)
    if not place.is_file():
        pytest.skip(f"{platform.name}-{build.tag(python)} is not built")
    return place


def own_module():
    """That of this suite, which takes everything from Debian's libraries."""
    return Path(loader.load().__file__)


@pytest.mark.parametrize("platform, python", MODULES)
def test_a_module_needs_nothing_but_the_system(platform, python):
    assert checks.problems(module(platform, python), platform, python) == []


@pytest.mark.parametrize("platform", toolchain.PLATFORMS.values(), ids=lambda platform: platform.name)
def test_the_zip_of_a_platform_has_at_most_10_mb(platform):
    """Its modules, and all files of the extension, compressed as zip files have them; names and licenses of the wheels
    are 148 kB more."""
    modules = [module(platform, python) for python in toolchain.PYTHONS]
    files = [file for folder in ("addon", "shaders") for file in (PROJECT / folder).rglob("*") if file.is_file()]
    rest = [file for file in files if file.suffix not in (".pyi", ".pyc")]
    assert sum(len(zlib.compress(file.read_bytes(), 9)) for file in (*modules, *rest)) < 9_850_000


def test_a_module_that_needs_libraries_of_debian_is_found_out():
    found = " ".join(checks.problems(own_module(), LINUX, "3.13"))
    if not found:
        pytest.skip("these tests run with a self-contained module")
    for library in ("libtbb.so.12", "libstdc++.so.6", "libOpenMeshCore.so"):
        assert f"it needs {library}" in found
    assert "of glibc 2.3" in found or "of glibc 2.4" in found


def test_the_interface_of_a_module_is_read():
    found = interface.read(own_module())
    assert found.exports == {"PyInit__native"} and found.imports["PyExc_ValueError"] == ""
    assert found.imports["malloc"].startswith("GLIBC_2.")


def test_what_is_no_library_is_told(tmp_path):
    file = tmp_path / "_native.so"
    file.write_text("no library")
    assert "cannot be read" in checks.problems(file, LINUX, "3.11")[0]


def problems(monkeypatch, platform, **members):
    """Of a module with such an interface, for Python 3.11 with one name."""
    monkeypatch.setattr(interface, "read", lambda _file: interface.Interface(**members))
    return checks.problems(Path("_native"), platform, "3.11", {"PyList_New": False})


def test_newer_glibc_and_loose_symbols_are_found(monkeypatch):
    imports = {"powf": "GLIBC_2.29", "scalable_malloc": "", "PyList_New": "", "log": "GLIBC_2.28", "f": "GLIBCXX_3.4"}
    found = problems(monkeypatch, LINUX, exports={"PyInit__native"}, imports=imports | COPYING)
    assert found == [
        "f is taken from a library of version GLIBCXX_3.4",
        "powf is of glibc 2.29, newer than 2.28",
        "scalable_malloc would be taken from whatever has it in Blender",
    ]


def test_linux_modules_copy_memory_by_the_c_library(monkeypatch):
    imports = {name: version for name, version in COPYING.items() if name != "memset"}
    found = problems(monkeypatch, LINUX, exports={"PyInit__native"}, imports=imports)
    assert found == ["its memset is not that of the C library"]


def test_symbols_that_are_handed_out_are_found(monkeypatch):
    found = problems(monkeypatch, LINUX, exports={"PyInit__native", "_Znwm"}, imports=COPYING)
    assert found == ["it hands out _Znwm, which another library may take for its own"]


def test_windows_modules_take_pythons_names_from_their_python_alone(monkeypatch):
    imports = {"PyList_New": "python313.dll", "PyList_Old": "python311.dll", "malloc": "api-ms-win-crt-heap-l1-1-0.dll"}
    libraries = {"KERNEL32.dll", "python311.dll", "python313.dll", "MSVCP140.dll", "api-ms-win-crt-heap-l1-1-0.dll"}
    found = problems(monkeypatch, WINDOWS, exports={"PyInit__native"}, imports=imports, libraries=libraries)
    assert found == [
        "it needs MSVCP140.dll, which is no part of the system",
        "it needs python313.dll, which is no part of the system",
        "PyList_New is taken from python313.dll, not from python311.dll",
        "it asks for PyList_Old, which Python 3.11 does not have",
    ]


def test_macos_modules_are_signed_and_for_old_systems_and_use_what_is_their_own(monkeypatch):
    found = problems(
        monkeypatch, MACOS, exports={"_PyInit__native"}, imports={"_PyList_New": "", "_x": ""}, system="12.0",
        libraries={"/usr/lib/libSystem.B.dylib", "/usr/lib/libc++.1.dylib"}, replaceable={"__Znwm"},
    )  # fmt: skip
    assert [sentence.split(",")[0] for sentence in found] == [
        "it needs /usr/lib/libc++.1.dylib",
        "_x would be taken from whatever has it in Blender",
        "it uses __Znwm of whichever library in Blender has it first",
        "it is for macOS 12.0",
        "it is not signed",
    ]


def test_inside_blender_nothing_is_taken_from_blenders_libraries(tmp_path):
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    if not BLENDER or version not in toolchain.PYTHONS:
        pytest.skip(f"there is no module for a Blender with Python {version}")
    file = module(LINUX, version)
    found = bindings.inside(BLENDER, file, tmp_path)
    assert len(found) > 2 and bindings.strange(found, str(file)) == {}


def test_a_symbol_of_blenders_libraries_is_found():
    line = "   7:\tbinding file /a/_native.so [0] to /lib/libtbbmalloc.so.2 [0]: normal symbol `scalable_malloc'\n"
    found = bindings.told(line + line.replace("libtbbmalloc.so.2", "libc.so.6"), "/a/_native.so")
    assert bindings.strange(found, "/a/_native.so") == {"/lib/libtbbmalloc.so.2": {"scalable_malloc"}}
