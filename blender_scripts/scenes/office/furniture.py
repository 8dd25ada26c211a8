# SPDX-License-Identifier: GPL-3.0-or-later
"""Furniture by name: imported from a folder of models if available, else generated. Each is one mesh in meters,
standing on z = 0, centered over the origin, facing -y."""

from pathlib import Path

import bpy
from mathutils import Matrix, Vector

from . import modelled

CENTIMETRES = 0.01


class Furniture:
    def __init__(self, shared: Path | None):
        self.folder = shared / "models" / "furniture" if shared else None
        self.meshes = {}

    def mesh(self, name: str):
        if name not in self.meshes:
            model = self.folder / f"{name}.obj" if self.folder else None
            self.meshes[name] = imported(model) if model and model.is_file() else modelled.MAKERS[name]()
            self.meshes[name].name = name
        return self.meshes[name]


def imported(model: Path):
    """The parts of a model file as one mesh. Edges and smoothness stay as they are in the file."""
    known = set(bpy.data.objects)
    bpy.ops.wm.obj_import(filepath=str(model))
    parts = [part for part in bpy.data.objects if part not in known]
    with bpy.context.temp_override(
        active_object=parts[0], object=parts[0], selected_objects=parts, selected_editable_objects=parts
    ):
        if len(parts) > 1:
            bpy.ops.object.join()
    made = parts[0].data
    made.transform(Matrix.Scale(CENTIMETRES, 4) @ parts[0].matrix_world)
    bpy.data.objects.remove(parts[0])
    corners = [Vector(point.co) for point in made.vertices]
    low, high = (Vector(pick(c[axis] for c in corners) for axis in range(3)) for pick in (min, max))
    made.transform(Matrix.Translation(Vector((-(low.x + high.x) / 2, -(low.y + high.y) / 2, -low.z))))
    for material in made.materials:
        plain(material)
    return made


def plain(material):
    """Copies a material's base color to its viewport color, and removes its image textures."""
    shader = material.node_tree.nodes.get("Principled BSDF") if material and material.node_tree else None
    if shader:
        socket = shader.inputs["Base Color"]
        for link in list(socket.links):
            material.node_tree.links.remove(link)
        material.diffuse_color = (*socket.default_value[:3], 1)
