# SPDX-License-Identifier: GPL-3.0-or-later
"""Access to the add-on's preferences, which ui/preferences.py declares."""

import bpy

ADDON = __package__.rpartition(".")[0]


def own():
    """The add-on's preferences; None if Blender has none for it (a script registered it directly)."""
    entry = bpy.context.preferences.addons.get(ADDON)
    return entry.preferences if entry else None
