# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the colors of a scene for native ColorSources: materials, images, attributes and the world."""

import weakref
from dataclasses import replace

from . import color_nodes, kept, materials, shader_links
from .color_corners import Corners
from .color_images import ImageCache
from .vertex_groups import Weights


class ColorCache:
    """Cache of textures and refined attributes between pictures."""

    def __init__(self, core):
        self.images = ImageCache(core)
        self.refined = {}  # attributes of refined surfaces, see color_corners.py
        self.weights = Weights()
        self.used = 0
        self.shown = weakref.WeakValueDictionary()  # id -> living ColorSources that use this cache
        kept.add_cache(self, core)

    def items(self, _needed):
        """The whole cache as one kept.Item, pinned while any ColorSources made with it are alive."""
        read = [entry[-1].nbytes for entry in self.refined.values()]
        return [
            kept.Item(
                self.used, self.images.size() + self.weights.size() + sum(read), None if self.shown else self._clear
            )
        ]

    def _clear(self):
        self.images.clear()
        self.weights.forget()
        self.refined.clear()


class Gathering:
    """Collects colors during the traversal of a scene: one entry per native surface, in order."""

    def __init__(self, core, cache):
        self._core, self._cache = core, cache
        cache.used = kept.now()
        self._sources = {}  # by material
        self.surfaces = []
        self.unfollowed = set()  # materials whose nodes were not followed

    def add_surface(self, obj, mesh, surface, cage, repaired):
        """Adds the colors of an evaluated mesh and its native surface. `cage()`: a context with the mesh that a refined
        surface was made from. For a repaired surface only material colors are used, as its corners are not the mesh's.
        """
        found = materials.of(obj, mesh)
        if repaired or not len(mesh.loops):
            sources = [self._source(material) for material in found]
            slots = [self._core.ColorSlot(s.plain, opacity=s.opacity) for s in sources]
            self.surfaces.append(self._core.SurfaceColor(slots))
            return
        corners = Corners(self._core, obj, mesh, surface, cage, self._cache)
        slots = [self._slot(material, corners) for material in found]
        normals = corners.normals()
        self.surfaces.append(self._core.SurfaceColor(slots, normals, corners.uvs, corners.attributes))

    def sources(self, scene, snapshot):
        """The native ColorSources of a Snapshot."""
        surfaces = [self.surfaces[i] for i in snapshot.surface_of_placement.tolist()]
        made = self._core.ColorSources(surfaces, snapshot.native_lights(self._core), _world(scene))
        self._cache.shown[id(made)] = made
        return made

    def remarks(self):
        """A list with one sentence on materials whose nodes were not followed; [] if there are none."""
        names = sorted(self.unfollowed)
        shown = ", ".join(f"'{name}'" for name in names[:3]) + (f" and {len(names) - 3} more" if names[3:] else "")
        return [f"Colors of nodes that are not followed are drawn as in the viewport: {shown}"] if names else []

    def _source(self, material):
        name = material and material.name_full
        if name not in self._sources:
            self._sources[name] = found = replace(color_nodes.source(material), opacity=materials.opacity(material))
            if not found.followed:
                self.unfollowed.add(name)
        return self._sources[name]

    def _slot(self, material, corners):
        """The native ColorSlot; the viewport color if an image, a UV map or an attribute is missing."""
        source = self._source(material)
        texture = source.image and self._cache.images.texture(source.image)
        uv = corners.uv(source.uv, source.place) if texture else None
        attribute = None if source.attribute is None else corners.attribute(source.attribute)
        if (source.image and uv is None) or (material and source.attribute is not None and attribute is None):
            self.unfollowed.add(material.name_full)
            return self._core.ColorSlot(source.viewport, unlit=source.unlit, opacity=source.opacity)
        own = (1.0, 1.0, 1.0) if attribute is not None else source.color
        return self._core.ColorSlot(own, texture, uv, attribute, source.unlit, source.opacity)


def _world(scene):
    """RGB radiance of the sky: the Background node's color times its strength, or the world's viewport color if that is
    linked; black without a world."""
    world = scene.world
    if world is None:
        return (0.0, 0.0, 0.0)
    output = world.node_tree.get_output_node("ALL") if world.node_tree and getattr(world, "use_nodes", True) else None
    shader = shader_links.source(output.inputs["Surface"]) if output else None
    if shader is not None and shader.type == "BACKGROUND" and not shader.inputs["Color"].links:
        strength = shader.inputs["Strength"].default_value
        return tuple(strength * channel for channel in tuple(shader.inputs["Color"].default_value)[:3])
    return tuple(world.color)
