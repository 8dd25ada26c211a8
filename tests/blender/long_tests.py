# SPDX-License-Identifier: GPL-3.0-or-later
"""What is left to `fovea test --long`, whose tests/long/test_inside_blender.py runs it."""

import os

import pytest

IS_LONG = os.environ.get("FOVEA_LONG") == "1"
takes_long = pytest.mark.skipif(not IS_LONG, reason="it takes long: `fovea test --long` runs it")
