# SPDX-License-Identifier: GPL-3.0-or-later
"""Keyed and driven numbers of what stands in lists, line sets and places to look at: their paths say the place in the
list, so they follow it when it moves."""

import re

LINE_SET = re.compile(r"(fovea\.line_sets\[)(\d+)(\].*)")
FOCUS_POINT = re.compile(r"(fovea\.focus_points\[)(\d+)(\].*)")


def follow(animated, places, path=LINE_SET):
    """Element i of a list of a style, or of a scene, is now at places[i]; None: it is gone, and what animates it."""
    data = animated.animation_data
    for owner in (data.drivers, *curves(animated)) if data else ():
        for channel in list(owner):
            found = path.fullmatch(channel.data_path)
            if not found or int(found[2]) >= len(places):
                continue
            place = places[int(found[2])]
            if place is None:
                owner.remove(channel)
            elif place != int(found[2]):
                channel.data_path = f"{found[1]}{place}{found[3]}"


def own_action(tree):
    """A copy of a style shall be animated by itself."""
    data = tree.animation_data
    if data and data.action:
        slot = getattr(data, "action_slot", None)
        name = slot and slot.identifier
        data.action = data.action.copy()
        if name:
            data.action_slot = data.action.slots[name]


def curves(animated):
    """The collections of F-curves of an ID that has animation data; their home moved when actions got layers."""
    data = animated.animation_data
    if data.action is None:
        return
    if not hasattr(data, "action_slot"):  # before Blender 4.4
        yield data.action.fcurves
        return
    for layer in data.action.layers:
        for strip in layer.strips:
            bag = strip.channelbag(data.action_slot) if data.action_slot else None
            if bag:
                yield bag.fcurves
