# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps F-curves and drivers of list elements (line sets, focus points) on their elements when a list is reordered: RNA
paths contain the index."""

import re

LINE_SET = re.compile(r"(fovea\.line_sets\[)(\d+)(\].*)")
FOCUS_POINT = re.compile(r"(fovea\.focus_points\[)(\d+)(\].*)")


def follow(animated, places, path=LINE_SET):
    """Updates the animation of an ID after a list was edited: element i is now at places[i]; None: it was removed, so
    its F-curves and drivers are, too. `path`: pattern of RNA paths into the list, with the index as group 2."""
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


def take_place(animated, start, other, names):
    """Moves F-curves and drivers whose RNA paths begin with `start` to paths that begin with `other`; those there for
    the properties `names` are removed."""
    data, gone = animated.animation_data, {f"{other}{name}" for name in names}
    for owner in (data.drivers, *curves(animated)) if data else ():
        for channel in [channel for channel in owner if channel.data_path in gone]:
            owner.remove(channel)
        for channel in [channel for channel in owner if channel.data_path.startswith(start)]:
            channel.data_path = other + channel.data_path.removeprefix(start)


def own_action(tree):
    """Gives a copied style its own copy of the action, keeping the assigned slot."""
    data = tree.animation_data
    if data and data.action:
        slot = getattr(data, "action_slot", None)
        name = slot and slot.identifier
        data.action = data.action.copy()
        if name:
            data.action_slot = data.action.slots[name]


def is_keyed(group, name):
    """Whether a property of a group of properties has an F-curve."""
    return any(True for _ in channels(group, name))


def channels(group, name):
    """Yields the F-curves of a property of a group of properties."""
    owner, path = group.id_data, group.path_from_id(name)
    for of_action in curves(owner) if owner.animation_data else ():
        yield from (curve for curve in of_action if curve.data_path == path)


def curves(animated):
    """Yields the F-curve collections of an ID with animation data, for legacy and for layered actions."""
    data = animated.animation_data
    if data.action is None:
        return
    if not hasattr(data, "action_slot"):  # before Blender 4.4
        yield data.action.fcurves
        return
    for layer in data.action.layers:
        for strip in layer.strips:
            if bag := strip.channelbag(data.action_slot) if data.action_slot else None:
                yield bag.fcurves
