"""Where the colours of a scene come from: materials, images, attributes, lights and the world, as plain arrays."""

import math

import numpy as np

from .. import color
from . import color_nodes, materials
from .color_images import ImageCache


class ColorCache:
    """What is kept from picture to picture."""

    def __init__(self, core):
        self.images = ImageCache(core)


class Gathering:
    """Colours as a scene is walked over: one entry per native surface, in the scene's order."""

    def __init__(self, core, cache):
        self._core, self._cache = core, cache
        self._sources = {}  # by material
        self.surfaces, self.lights = [], []
        self.unfollowed = set()  # materials whose nodes were not followed

    def add_surface(self, obj, mesh, surface, repaired):
        """The colours of an evaluated mesh whose native surface is given. Where that has been refined or repaired its
        corners are no longer the mesh's, and nothing is read of them."""
        sources = [self._source(material) for material in materials.of(obj, mesh)]
        corners = _Corners(mesh, not repaired and not isinstance(surface, self._core.RefinedSurface))
        slots = [self._slot(source, corners) for source in sources]
        normals = corners.normals()
        self.surfaces.append(self._core.SurfaceColor(slots, normals, corners.uvs, corners.attributes))

    def add_light(self, instance):
        """An instance of a light."""
        data, matrix = instance.object.data, np.array(instance.matrix_world)
        strength = data.energy * 2.0 ** getattr(data, "exposure", 0.0)
        # Blender's watts: those of points and spots go out all around, those of areas to one side.
        spread = {"SUN": 1.0, "POINT": 4 * math.pi, "SPOT": 4 * math.pi, "AREA": math.pi}[data.type]
        cone = ()
        if data.type == "SPOT":
            outer = math.cos(data.spot_size / 2)
            cone = (outer, outer + (1 - outer) * data.spot_blend)
        shade = tuple(channel * strength / spread for channel in data.color)
        self.lights.append(self._core.Light(data.type.lower(), matrix[:3, 3], -matrix[:3, 2], shade, *cone))

    def sources(self, scene, surface_of_placement):
        """The color.Sources of a scene whose placements have these surfaces."""
        return color.Sources([self.surfaces[i] for i in surface_of_placement], self.lights, _world(scene))

    def remark(self):
        """A sentence about what could not be followed, or None."""
        names = sorted(self.unfollowed)
        if not names:
            return None
        shown = ", ".join(f"'{name}'" for name in names[:3]) + (f" and {len(names) - 3} more" if names[3:] else "")
        return f"Colours of nodes that are not followed are drawn as in the viewport: {shown}"

    def _source(self, material):
        name = material and material.name_full
        if name not in self._sources:
            self._sources[name] = found = color_nodes.source(material)
            if not found.followed:
                self.unfollowed.add(name)
        return self._sources[name]

    def _slot(self, source, corners):
        """The native slot; an image, a UV map or an attribute that is missing leaves the colour."""
        texture = source.image and self._cache.images.texture(source.image)
        uv = corners.uv(source.uv, source.place) if texture else None
        return self._core.ColorSlot(
            source.color, texture if uv is not None else None, uv, corners.attribute(source.attribute), source.unlit
        )


class _Corners:
    """Attributes of a mesh at its corners, read when first asked for. `fits`: the native
    surface has the same ones."""

    def __init__(self, mesh, fits):
        self._mesh, self._fits = mesh, fits
        self._known = {}
        self.uvs, self.attributes = [], []

    def normals(self):
        if not self._fits or not len(self._mesh.loops):
            return None
        return self._read(self._mesh.corner_normals, "vector", 3)

    def uv(self, name, place):
        """Which of `uvs` holds a UV map, mapped; None where there is none."""
        mesh = self._mesh
        if name == color_nodes.ACTIVE:
            name = next((layer.name for layer in mesh.uv_layers if layer.active_render), None)
        found = mesh.attributes.get(name) if name else None
        if not self._fits or found is None or (found.data_type, found.domain) != ("FLOAT2", "CORNER"):
            return None
        return self._index(self.uvs, (name, place), lambda: _mapped(self._read(found.data, "vector", 2), place))

    def attribute(self, name):
        """Which of `attributes` holds a colour attribute; None where there is none."""
        mesh = self._mesh
        if name == color_nodes.ACTIVE:
            index = mesh.color_attributes.render_color_index
            name = mesh.color_attributes[index].name if 0 <= index < len(mesh.color_attributes) else None
        found = mesh.attributes.get(name) if name else None
        if not self._fits or found is None or found.domain not in {"POINT", "CORNER"}:
            return None
        if found.data_type not in {"FLOAT_COLOR", "BYTE_COLOR"}:
            return None
        return self._index(self.attributes, name, lambda: self._colors(found))

    def _colors(self, attribute):
        """(C, 3) scene-linear colours."""
        colors = self._read(attribute.data, "color", 4)[:, :3]
        if attribute.domain == "POINT":
            vertices = np.empty(len(self._mesh.loops), np.int32)
            self._mesh.attributes[".corner_vert"].data.foreach_get("value", vertices)
            colors = colors[vertices]
        return np.ascontiguousarray(colors)

    def _index(self, arrays, name, read):
        key = (id(arrays), name)
        if key not in self._known:
            self._known[key] = len(arrays)
            arrays.append(read())
        return self._known[key]

    @staticmethod
    def _read(data, what, columns):
        values = np.empty((len(data), columns), np.float32)
        data.foreach_get(what, values.ravel())
        return values


def _mapped(uvs, place):
    if place == color_nodes.Source.place:
        return uvs
    rows = np.array(place, np.float32).reshape(2, 3)
    return uvs @ rows[:, :2].T + rows[:, 2]


def _world(scene):
    """Radiance of the sky: the background's colour, or the world's own where nodes make it."""
    world = scene.world
    if world is None:
        return (0.0, 0.0, 0.0)
    output = world.node_tree.get_output_node("ALL") if world.node_tree and getattr(world, "use_nodes", True) else None
    shader = materials.source(output.inputs["Surface"]) if output else None
    if shader is not None and shader.type == "BACKGROUND" and not shader.inputs["Color"].links:
        strength = shader.inputs["Strength"].default_value
        return tuple(strength * channel for channel in tuple(shader.inputs["Color"].default_value)[:3])
    return tuple(world.color)
