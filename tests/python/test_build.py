# SPDX-License-Identifier: GPL-3.0-or-later
"""The options with which the native module is built."""

import re
from pathlib import Path

import pytest
from command import build, precompiled, sanitizers
from command.target import Target

RUN_TESTS = Path(build.__file__).with_name("run_tests.sh")


@pytest.mark.parametrize("name, wanted", [("sid", "OFF"), ("trixie", "ON"), ("own-5.2-1234", "OFF")])
def test_warnings_are_errors_where_the_compiler_stays_the_same(tmp_path, name, wanted):
    target = Target(name, tmp_path / "work", tmp_path / "cache", "blender", "")
    for sanitize in (False, True):
        assert f"-DCMAKE_COMPILE_WARNING_AS_ERROR={wanted}" in build.cmake_options(target, sanitize)


def test_clang_compiles_in_trixie_what_runs_under_sanitizers_and_nothing_else(tmp_path):
    compiler = [f"-DCMAKE_CXX_COMPILER={sanitizers.COMPILERS['trixie']}"]
    for name, sanitize, wanted in (("trixie", True, compiler), ("trixie", False, []), ("sid", True, [])):
        target = Target(name, tmp_path / "work", tmp_path / "cache", "blender", "")
        options = build.cmake_options(target, sanitize)
        assert [option for option in options if "COMPILER=" in option] == wanted
    names = re.search(r"set_up_suite trixie (\w.*)", RUN_TESTS.read_text(encoding="utf-8"))[1].split()
    assert sanitizers.COMPILERS["trixie"].replace("++", "") in names


def test_precompiled_headers_of_other_options_are_deleted_as_ccache_would_take_them_for_input(tmp_path, monkeypatch):
    monkeypatch.setattr(precompiled, "PROJECT", tmp_path)
    (tmp_path / "CMakeLists.txt").write_text("add_compile_options(-Wall)")
    folder = tmp_path / "release"
    headers = [folder / "CMakeFiles" / "core.dir" / f"cmake_pch.hxx.{ending}" for ending in ("gch", "pch")]
    headers[0].parent.mkdir(parents=True)

    def kept():
        for header in headers:
            header.touch()
        precompiled.forget_changed(folder)
        return [header.exists() for header in headers]

    assert kept() == [False, False]  # nobody knows by which options they were compiled
    assert kept() == [True, True]
    (tmp_path / "CMakeLists.txt").write_text("add_compile_options(-Wextra)")
    assert kept() == [False, False]
