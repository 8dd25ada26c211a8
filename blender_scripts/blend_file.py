# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens Blender files for the scripts that `fovea` runs inside Blender."""

from pathlib import Path

import bpy


def open_file(path, *, use_scripts=False):
    """Opens a .blend, without running its scripts if not asked to. The operator raises RuntimeError even if the file
    was opened, when it reports missing parts as errors; only failures to open the file are raised."""
    try:
        bpy.ops.wm.open_mainfile(filepath=str(path), load_ui=False, use_scripts=use_scripts)
    except RuntimeError:
        if not (bpy.data.filepath and Path(bpy.data.filepath).samefile(path)):
            raise
