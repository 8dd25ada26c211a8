# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that use a GPU run on the back end that Blender was asked for, and not on one that it falls back to."""

import sys

import pytest


@pytest.mark.gpu
def test_the_back_end_is_that_which_blender_was_asked_for():
    import gpu  # has a context only inside a render

    words = sys.argv
    asked = words[words.index("--gpu-backend") + 1] if "--gpu-backend" in words else "opengl"
    assert gpu.platform.backend_type_get() == asked.upper()
