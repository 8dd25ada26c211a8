# SPDX-License-Identifier: GPL-3.0-or-later
"""Preferences of the add-on."""

import logging

import bpy

from .. import native, style
from ..scene import kept
from ..scene.own_preferences import ADDON, own
from ..style import style_files

LOG_LEVELS = [
    ("ERROR", "Errors", "Only what went wrong"),
    ("WARNING", "Warnings", "Also what may look wrong"),
    ("INFO", "Information", "Also what is done, and how long it takes"),
    ("DEBUG", "All", "What helps to find faults"),
]


def _applied(preferences, _context):
    apply(preferences)


def _style_names(_preferences, _context, _typed):
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
        if problem := native.problem():
            column.label(text=problem, icon="ERROR")
        for name in ("default_style", "background_gpu", "threads", "memory_limit", "log_level"):
            column.prop(self, name)


def apply(preferences):
    """Applies the preferences: log level and, if the native module is available, threads and memory limit."""
    logging.getLogger(ADDON).setLevel(preferences.log_level)
    if not native.problem():
        native.load().limit_threads(preferences.threads)
        kept.set_limit(preferences.memory_limit)


def register():
    if own():
        apply(own())
