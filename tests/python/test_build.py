# SPDX-License-Identifier: GPL-3.0-or-later
"""The options with which the native module is built."""

import pytest
from command import build
from command.target import Target


@pytest.mark.parametrize("name, wanted", [("sid", "OFF"), ("trixie", "ON"), ("own-5.2-1234", "OFF")])
def test_warnings_are_errors_where_the_compiler_stays_the_same(tmp_path, name, wanted):
    target = Target(name, tmp_path / "work", tmp_path / "cache", "blender", "")
    for sanitize in (False, True):
        assert f"-DCMAKE_COMPILE_WARNING_AS_ERROR={wanted}" in build.cmake_options(target, sanitize)
