# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea test`: blender -b -P run.py -- PYTEST ARGUMENTS. Blender's exit code is pytest's."""

import sys
from pathlib import Path

import pytest


def main():
    words = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    status = pytest.main([str(Path(__file__).parent), *words])
    sys.stdout.flush()
    sys.exit(int(status))


main()
