# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the project importable: `addon` (the staged package with the native module, as `fovea test` names it, else the
checkout's), and `command` and `scenes` of blender_scripts."""

import importlib.util
import sys
from pathlib import Path

PROJECT = Path(__file__).parents[2]

if importlib.util.find_spec("addon") is None:
    sys.path.insert(0, str(PROJECT))
sys.path.insert(0, str(PROJECT / "blender_scripts"))
