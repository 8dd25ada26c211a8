# SPDX-License-Identifier: GPL-3.0-or-later
"""What a viewport knows of the scene, and whether it has to read it again.

Blender reports which of its data changed. Selections, cameras and styles change nothing that is read of the scene; but
what hides an object may be reported in the same way, so that what is placed where is compared.
"""

from dataclasses import dataclass

import bpy

from .. import catalogue
from ..scene import notes, scene, subdivision
from . import properties, reading, session, worker

# What an update of these alone leaves as it was, unless what is placed where tells otherwise.
HARMLESS = (bpy.types.Scene, bpy.types.Camera, bpy.types.NodeTree, bpy.types.WindowManager, bpy.types.Screen)


@dataclass(frozen=True)
class Scene:
    """What was read; another version may look otherwise."""

    version: int
    style: object
    gathered: reading.Read


class Changes:
    """One viewport's."""

    def __init__(self):
        self._scene = None
        self._told = self._must_read = True  # since the last time: there were updates; and not just harmless ones
        self._placements = self._needs = self._space = None

    def note(self, updates):
        """Blender has updated its scene. Our own reading of a cage (subdivision.py) changes nothing."""
        if subdivision.is_echo(updates):
            return
        self._told = True
        self._must_read = self._must_read or not are_harmless(list(updates))

    def read(self, engine, depsgraph, space):
        """The Scene as it is now, for a SpaceView3D."""
        shows = _shows(space)
        if self._scene is not None and not self._told and shows == self._space:
            return self._scene
        style = properties.style_of(depsgraph.scene_eval)
        needs = _needs(style, properties.density_map(depsgraph.scene_eval))
        placements = scene.placements(depsgraph, space)
        found, version = self._scene and self._scene.gathered, self._scene.version if self._scene else 0
        if self._scene is None or self._must_read or (needs, placements) != (self._needs, self._placements):
            worker.stop()  # it looks at surfaces that may change now
            found = session.gather(engine, depsgraph, style, space)
            version += 1
        elif style != self._scene.style:
            version += 1
        self._scene = Scene(version, style, found)
        self._told = self._must_read = False
        self._placements, self._needs, self._space = placements, needs, shows
        return self._scene


def are_harmless(updates):
    """Whether updates leave alone what is read of the scene. With a scene its objects are reported, as shaded anew."""
    of_scene = any(isinstance(update.id, bpy.types.Scene) for update in updates)
    return bool(updates) and all(_is_harmless(update, of_scene) for update in updates)


def _is_harmless(update, of_scene):
    data = update.id
    if isinstance(data, bpy.types.Object):
        moved = update.is_updated_geometry or update.is_updated_transform
        return data.type == "CAMERA" or (of_scene and not moved)
    return isinstance(data, HARMLESS)


def _needs(style, density_map):
    """What a style asks of the scene besides its shapes."""
    marks = catalogue.read_edge_marks(style.line_sets)
    return marks, style.has_color(), notes.asked(style, density_map)


def _shows(space):
    """What of the scene a 3D view shows is in part its own."""
    switches = [name for name in space.bl_rna.properties.keys() if name.startswith("show_object_viewport_")]
    own = space.local_view is not None, space.use_local_collections
    return *own, *(getattr(space, name) for name in switches)
