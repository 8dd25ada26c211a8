# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user prefers, for whoever asks: ui/preferences.py declares it."""

import bpy

ADDON = __package__.rpartition(".")[0]


def own():
    """The add-on's preferences; None where Blender has none for it (scripts that register it by hand)."""
    entry = bpy.context.preferences.addons.get(ADDON)
    return entry.preferences if entry else None
