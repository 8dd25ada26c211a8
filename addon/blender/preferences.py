"""Preferences of the add-on, and whether renders may ask Blender for a GPU context."""

import functools
import os
import subprocess
import sys
from pathlib import Path

import bpy

ADDON = __package__.rpartition(".")[0]
SEEN = "FOVEA_GL_RENDERER"  # set for child processes: what the probe found, empty for nothing usable


class FoveaPreferences(bpy.types.AddonPreferences):
    bl_idname = ADDON

    background_gpu: bpy.props.BoolProperty(
        name="GPU in Background Renders",
        description="Look for OpenGL when Blender starts without a window; else such renders use the CPU alone",
        default=True,
    )

    def draw(self, context):
        self.layout.prop(self, "background_gpu")


@functools.cache
def gl_renderer():
    """Name of the OpenGL renderer that a render in this process would get; None where it must not ask for one.

    Blender without a window aborts when it is asked for a context that it cannot make, so a child process tries first.
    """
    if os.environ.get("FOVEA_BACKEND", "").lower() == "cpu":
        return None
    if not bpy.app.background:
        return "window"
    entry = bpy.context.preferences.addons.get(ADDON)
    # Elsewhere than on Linux there is no cheap way to know.
    if not sys.platform.startswith("linux") or (entry and entry.preferences and not entry.preferences.background_gpu):
        return None
    if SEEN not in os.environ:
        os.environ[SEEN] = _probe()
    return os.environ[SEEN] or None


def _probe():
    script = Path(__file__).with_name("gl_probe.py")
    try:
        found = subprocess.run([sys.executable, "-I", str(script)], capture_output=True, text=True, timeout=20)
    except (OSError, subprocess.TimeoutExpired) as error:
        print(f"Fovea: no GPU context for renders: {error}")
        return ""
    return found.stdout.strip() if found.returncode == 0 else ""


def register():
    bpy.utils.register_class(FoveaPreferences)


def unregister():
    bpy.utils.unregister_class(FoveaPreferences)
