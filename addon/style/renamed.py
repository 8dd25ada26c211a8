# SPDX-License-Identifier: GPL-3.0-or-later
"""Filters of line sets follow collections, objects and materials that are renamed.

Filters hold names. Pointers would follow by themselves, but a style that is appended or linked would bring what they
point to along, with all that belongs to it; a name finds the datablock of that name in each file. So it is remembered
which datablock each name means in this session, and a name is changed when its datablock has another one.
"""

import bpy
from bpy.app.handlers import persistent

from . import FILTERS, style_data

KINDS = {"collection": "collections", "object": "objects", "material": "materials"}  # filter -> name in bpy.data

_meant = {}  # (filter, name) of all filters -> session_uid of the datablock that it means
_owner = object()  # of the subscription to names


def _filters():
    """(line set, filter, name) of all filters that styles of this file have."""
    for tree in bpy.data.node_groups:
        if tree.library is None and style_data.is_style(tree):
            for line_set in tree.fovea.line_sets:
                yield from ((line_set, kind, getattr(line_set, kind)) for kind in FILTERS if getattr(line_set, kind))


def _named_now(kind, name):
    """The present name of the local datablock that a filter's name means; `name` if that is not known or is gone."""
    known, uid = getattr(bpy.data, KINDS[kind]), _meant.get((kind, name))
    here = known.get(name)
    if uid is None or (here and here.session_uid == uid):
        return name
    return next((one.name for one in known if one.session_uid == uid), name)


def follow(*_arguments):
    """Changes names in filters whose datablocks were renamed, and remembers what all names mean."""
    for line_set, kind, name in list(_filters()):
        if (now := _named_now(kind, name)) != name:
            setattr(line_set, kind, now)
    learn()


@persistent
def learn(*_arguments):
    """Remembers which datablocks the names in filters mean."""
    found = ((kind, name, getattr(bpy.data, KINDS[kind]).get(name)) for _, kind, name in _filters())
    fresh = {(kind, name): one.session_uid for kind, name, one in found if one}
    _meant.clear()
    _meant.update(fresh)


@persistent
def _followed(*_arguments):
    follow()


@persistent
def _listen(*_arguments):
    """Subscribes to names; Blender forgets subscriptions when it loads a file."""
    bpy.msgbus.clear_by_owner(_owner)
    bpy.msgbus.subscribe_rna(key=(bpy.types.ID, "name"), owner=_owner, args=(), notify=follow)
    learn()


_HANDLERS = (
    ("depsgraph_update_post", _followed),
    ("save_pre", _followed),
    ("load_post", _listen),
    ("undo_post", learn),
)


def register():
    for name, function in _HANDLERS:
        getattr(bpy.app.handlers, name).append(function)
    bpy.msgbus.subscribe_rna(key=(bpy.types.ID, "name"), owner=_owner, args=(), notify=follow)


def unregister():
    bpy.msgbus.clear_by_owner(_owner)
    for name, function in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(function)
    _meant.clear()
