# SPDX-License-Identifier: GPL-3.0-or-later
"""Decides when a viewport must read the scene again.

Blender reports which datablocks were updated. Updates of selections, cameras and styles do not change the geometry read
from the scene, but hiding an object may be reported in the same way; so the placements are compared as well.
"""

from dataclasses import dataclass

import bpy

from .. import catalogue
from ..scene import instances, notes, section, subdivision
from . import properties, reading, session, worker

# Updates of these types alone need no new reading, unless the placements differ.
HARMLESS = (bpy.types.Scene, bpy.types.Camera, bpy.types.NodeTree, bpy.types.WindowManager, bpy.types.Screen)


@dataclass(frozen=True)
class Scene:
    """The scene as read; `version` increases whenever the picture may look different, `moves` whenever what Blender
    draws over it may look different."""

    version: int
    moves: int
    style: object
    gathered: reading.Read


class Changes:
    """The state of one viewport. `style_of(depsgraph)`: the Style that it draws."""

    def __init__(self, style_of):
        self._style_of = style_of
        self._scene = None
        self._told = self._must_read = True  # since the last read: any updates; any that are not harmless
        self._placements = self._needs = self._space = None
        self.moves = 0  # how often objects may have moved, changed their shape or been hidden
        session.forget_weights()  # of what changed while there was no viewport, no update has told

    def note(self, updates):
        """Records the depsgraph's updates, except those caused by reading a cage (subdivision.py)."""
        if subdivision.is_echo(updates):
            return
        session.forget_weights(updates)
        self._told = True
        self._must_read = self._must_read or not are_harmless(list(updates))
        self.moves += any(map(_moves, updates))

    def forget(self):
        """What is read next, is read anew."""
        self._told = self._must_read = True

    def read(self, engine, depsgraph, space):
        """The current Scene for a SpaceView3D, read again only if something has changed."""
        shows = _shows(space)
        if self._scene is not None and not self._told and shows == self._space:
            return self._scene
        style = self._style_of(depsgraph)
        needs = (*_needs(style, properties.density_map(depsgraph)), section.plane_of(depsgraph))
        placements = instances.placements(depsgraph, space)
        found, version = self._scene and self._scene.gathered, self._scene.version if self._scene else 0
        if self._scene is None or self._must_read or (needs, placements) != (self._needs, self._placements):
            worker.stop()  # its thread reads surfaces that are modified here
            found = session.gather(engine, depsgraph, style, space)
            version += 1
        elif style != self._scene.style:
            version += 1
        self.moves += placements != self._placements  # of what is hidden, no update tells
        self._scene = Scene(version, self.moves, style, found)
        self._told = self._must_read = False
        self._placements, self._needs, self._space = placements, needs, shows
        return self._scene


def _moves(update):
    """Whether an update is of the place or the shape of an object; cameras change the view alone."""
    is_object = isinstance(update.id, bpy.types.Object) and update.id.type != "CAMERA"
    return is_object and (update.is_updated_geometry or update.is_updated_transform)


def are_harmless(updates):
    """Whether depsgraph updates do not affect what is read of the scene. An update of a Scene also reports its objects
    as shading updates; these are ignored."""
    of_scene = any(isinstance(update.id, bpy.types.Scene) for update in updates)
    return bool(updates) and all(_is_harmless(update, of_scene) for update in updates)


def _is_harmless(update, of_scene):
    data = update.id
    if isinstance(data, bpy.types.Object):
        moved = update.is_updated_geometry or update.is_updated_transform
        return data.type == "CAMERA" or (of_scene and not moved)
    return isinstance(data, HARMLESS)


def _needs(style, density_map):
    """What must be read for a style besides geometry: (edge marks, colors, attributes and filters); to be compared."""
    marks = catalogue.read_edge_marks(style.line_sets)
    return marks, style.has_color(), notes.asked(style, density_map)


def _shows(space):
    """The visibility settings of a 3D view itself (local view, local collections, object types); to be compared."""
    switches = [name for name in space.bl_rna.properties.keys() if name.startswith("show_object_viewport_")]
    own = space.local_view is not None, space.use_local_collections
    return *own, *(getattr(space, name) for name in switches)
