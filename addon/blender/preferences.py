# SPDX-License-Identifier: GPL-3.0-or-later
"""Preferences of the add-on, and whether renders may ask Blender for a GPU context."""

import functools
import logging
import os
import subprocess
import sys
from pathlib import Path

import bpy

from .. import native, style
from . import kept

ADDON = __package__.rpartition(".")[0]
SEEN = "FOVEA_GL_RENDERER"  # set for child processes: what the probe found, empty for nothing usable


LOG_LEVELS = [
    ("ERROR", "Errors", "Only what went wrong"),
    ("WARNING", "Warnings", "Also what may look wrong"),
    ("INFO", "Information", "Also what is done, and how long it takes"),
    ("DEBUG", "All", "What helps to find faults"),
]


def _applied(preferences, _context):
    apply(preferences)


def _style_names(_preferences, _context, _typed):
    from . import style_files  # which asks the preferences where files are

    return style_files.names()


class FoveaPreferences(bpy.types.AddonPreferences):
    bl_idname = ADDON

    background_gpu: bpy.props.BoolProperty(
        name="GPU in Background Renders",
        description="Look for OpenGL when Blender starts without a window; else such renders use the CPU alone",
        default=True,
    )
    default_style: bpy.props.StringProperty(
        name="Default Style",
        description="What New gives and the gallery shows first. Scenes without a style of their own draw in "
        f"{style.DEFAULT} however this is set, so that they look the same on every machine",
        default=style.DEFAULT,
        search=_style_names,
    )
    threads: bpy.props.IntProperty(
        name="Threads",
        description="Most threads that draw at once; 0: as many as the machine has. Pictures do not depend on it",
        default=0,
        min=0,
        soft_max=64,
        max=1024,
        update=_applied,
    )
    memory_limit: bpy.props.IntProperty(
        name="Memory Limit",
        description="Most megabytes that Fovea keeps from one picture for the next: meshes, what was found on them, "
        "and images of materials, reckoned by triangles and texels. Beyond it, what was unused longest is let go, and "
        "made again when it is needed. What viewports show stays, and drawing takes memory of its own. Pictures do not "
        "depend on it. 0: no limit",
        default=0,
        min=0,
        soft_max=65536,
        max=1 << 20,
        update=_applied,
    )
    log_level: bpy.props.EnumProperty(
        name="Log Level",
        description="What is told in the console",
        items=LOG_LEVELS,
        default="WARNING",
        update=_applied,
    )

    def draw(self, context):
        column = self.layout.column()
        column.use_property_split = True
        problem = native.problem()
        if problem:
            column.label(text=problem, icon="ERROR")
        column.prop(self, "default_style")
        column.prop(self, "background_gpu")
        column.prop(self, "threads")
        column.prop(self, "memory_limit")
        column.prop(self, "log_level")


def apply(preferences):
    """Makes what preferences say hold; without a native module there is nothing to limit."""
    logging.getLogger(ADDON).setLevel(preferences.log_level)
    if not native.problem():
        native.load().limit_threads(preferences.threads)
        kept.set_limit(preferences.memory_limit)


def own():
    """The add-on's preferences; None where Blender has none for it (scripts that register it by hand)."""
    entry = bpy.context.preferences.addons.get(ADDON)
    return entry.preferences if entry else None


@functools.cache
def gl_renderer():
    """Name of the OpenGL renderer that a render in this process would get; None where it must not ask for one.

    Blender without a window aborts when it is asked for a context that it cannot make, so a child process tries first.
    """
    if os.environ.get("FOVEA_BACKEND", "").lower() == "cpu":
        return None
    if not bpy.app.background:
        return "window"
    # Elsewhere than on Linux there is no cheap way to know.
    if not sys.platform.startswith("linux") or (own() and not own().background_gpu):
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
    if own():
        apply(own())


def unregister():
    bpy.utils.unregister_class(FoveaPreferences)
