# SPDX-License-Identifier: GPL-3.0-or-later
"""The options with which the native module is built."""

import pytest
from command import build, precompiled
from command.target import Target


@pytest.mark.parametrize("name, wanted", [("sid", "OFF"), ("trixie", "ON"), ("own-5.2-1234", "OFF")])
def test_warnings_are_errors_where_the_compiler_stays_the_same(tmp_path, name, wanted):
    target = Target(name, tmp_path / "work", tmp_path / "cache", "blender", "")
    for sanitize in (False, True):
        assert f"-DCMAKE_COMPILE_WARNING_AS_ERROR={wanted}" in build.cmake_options(target, sanitize)


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
