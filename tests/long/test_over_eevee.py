# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines over renders of EEVEE, which compiles its shaders for a minute on software OpenGL."""

import os
import subprocess
from pathlib import Path

import frames

RUN = Path(__file__).parents[1] / "blender" / "run.py"


def test_lines_lie_on_the_outlines_of_what_eevee_renders():
    words = [frames.BLENDER, "-b", "-P", RUN, "--", "-v", "-k", "closed_form_has_the_outlines and EEVEE"]
    told = subprocess.run(words, env=os.environ | {"FOVEA_LONG": "1"}, capture_output=True, text=True, errors="replace")
    assert told.returncode == 0 and "1 passed" in told.stdout, told.stdout + told.stderr
