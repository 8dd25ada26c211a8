# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on under test, independent of its installed name, and scenes to test it on."""

import importlib
import sys

import bpy
import numpy as np

fovea = next(
    module for name, module in sys.modules.items() if name.rpartition(".")[2] == "fovea" and hasattr(module, "register")
)


def part(name):
    """A module of the add-on: part("scene.scene")."""
    return importlib.import_module(f"{fovea.__name__}.{name}")


def own_style(scene):
    """The properties of a scene's own style, the default if it has none."""
    return part("style.style_data").own(scene)


def use_style(scene, wanted):
    """Draws with a Style, or a shipped one; its properties."""
    return part("style.style_data").use(scene, wanted)


def lines_of(scene):
    """The last line set of a scene's own style."""
    return own_style(scene).line_sets[-1]


def only_lines(scene, *names):
    """Draws these kinds of lines alone."""
    part("style.style_data").choose_lines(own_style(scene), names)


def add_hidden(line_set, first=1, last=None):
    """A hidden pen of dashes; its properties."""
    style = part("style")
    dashes = style.dashed(part("style.style_read").pen(line_set.pen))
    part("style.style_write").write_hidden(line_set.hidden.add(), style.Hidden(pen=dashes, first=first, last=last))
    return line_set.hidden[-1]


def empty_scene():
    """A scene of the file without objects."""
    bpy.ops.wm.read_homefile(use_empty=True)
    return bpy.context.scene


def grows(obj, times, first, last):
    """Keys a shape of a mesh object: it is as high as it was at the frame `first`, and so many times at `last`."""
    obj.shape_key_add(name="Basis")
    tall = obj.shape_key_add(name="Tall")
    for point in tall.data:
        point.co.z *= times
    for tall.value, frame in ((0, first), (1, last)):
        tall.keyframe_insert("value", frame=frame)


def new_object(data, name="Object", location=(0, 0, 0), collection=None):
    obj = bpy.data.objects.new(name, data)
    obj.location = location
    (collection or bpy.context.scene.collection).objects.link(obj)
    return obj


def new_mesh(vertices, edges, polygons, name="Mesh"):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, edges, polygons)
    return mesh


def box_mesh(half=1.0, name="Box"):
    corners = [(x * half, y * half, z * half) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return new_mesh(corners, [], quads, name)


def add_camera(location=(5, -7, 4), target=(0, 0, 0)):
    """An active camera that looks at a point."""
    camera = new_object(bpy.data.cameras.new("Camera"), "Camera", location)
    direction = camera.location.__class__(target) - camera.location
    camera.rotation_euler = direction.to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.camera = camera
    return camera


def a_box_to_look_at():
    """A scene of 400 x 200 pixels with a box beside the middle of it."""
    scene = empty_scene()
    scene.render.engine, scene.render.resolution_x, scene.render.resolution_y = "FOVEA", 400, 200
    new_object(box_mesh(), "Box", (1, 2, 0))
    add_camera((3, -16, 6), (0, 0, 0))
    bpy.context.view_layer.update()
    return scene


def mark_edges(mesh, *, sharp=(), seam=(), freestyle=()):
    """Marks edges by index, on either generation of Blender's API."""
    for index in sharp:
        mesh.edges[index].use_edge_sharp = True
    for index in seam:
        mesh.edges[index].use_seam = True
    if "use_freestyle_mark" in bpy.types.MeshEdge.bl_rna.properties:
        for index in freestyle:
            mesh.edges[index].use_freestyle_mark = True
    elif freestyle:
        values = np.zeros(len(mesh.edges), np.bool_)
        values[list(freestyle)] = True
        attribute = mesh.attributes.new("freestyle_edge", "BOOLEAN", "EDGE")
        attribute.data.foreach_set("value", values)


def shader_material(name, node_type):
    """A material with one shader node at its surface output."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    shader, output = tree.nodes.new(node_type), tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    return material
