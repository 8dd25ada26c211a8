# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the project importable: `addon` (the staged package with the native module, as `fovea test` names it, else the
checkout's), and `command` and `scenes` of blender_scripts."""

import importlib.util
import re
import sys
from pathlib import Path

PROJECT = Path(__file__).parents[2]

if importlib.util.find_spec("addon") is None:
    sys.path.insert(0, str(PROJECT))
sys.path.insert(0, str(PROJECT / "blender_scripts"))

# The commands are for Linux, and so are their tests, and those that measure processes; the module and the add-on are
# tested on every system.
FOR_LINUX = re.compile(r"^(from|import) (bench|command|own_blenders|resource)\b|\"blender_scripts\"", re.MULTILINE)
if not sys.platform.startswith("linux"):
    files = Path(__file__).parent.glob("test_*.py")
    collect_ignore = [file.name for file in files if FOR_LINUX.search(file.read_text(encoding="utf-8"))]
