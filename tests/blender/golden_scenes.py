# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenes of the golden images: small, drawn by the cpu backend with exact visibility, identical in every
Blender."""

import math
import sys
from functools import partial
from pathlib import Path

import bpy
from the_addon import add_camera, box_mesh, empty_scene, mark_edges, new_mesh, new_object, part, use_style

PROJECT = Path(__file__).parents[2]
sys.path.insert(0, str(PROJECT / "blender_scripts"))

import framing
import scenes
from command.target import SHARED

MODELS = {"crank_arm": SHARED / "models/cad/crank-arm.obj", "rocker_arm": SHARED / "models/organic/rocker-arm.obj"}
WIDTH, HEIGHT = 480, 270


def named(spec):
    scenes.build(spec)
    frame()


def model(path):
    """As `fovea draw` shows it."""
    bpy.ops.wm.obj_import(filepath=str(path))
    frame()
    framing.frame(bpy.context.scene, framing.AZIMUTH, framing.ELEVATION, framing.LENS, 0.05)


def styled(name):
    """Round and flat things with the pens of a style, as large as they are in a picture 1080 pixels high. Those with
    blacks have a sun."""
    box = new_object(box_mesh(0.8), "Box", (-1.5, 0.4, 0.8))
    box.rotation_euler.z = 0.4
    bpy.ops.mesh.primitive_torus_add(major_segments=96, minor_segments=24, major_radius=0.8, minor_radius=0.35)
    bpy.context.object.location = (0.5, -0.5, 0.35)
    bpy.ops.mesh.primitive_cone_add(location=(1.7, 1.4, 0.9), vertices=64, radius1=0.8, depth=1.8)
    # A little lower than what stands on it: faces in one plane hide each other by chance.
    new_object(tiles(), "Floor", (0, 0.2, -0.02))
    add_camera((1.5, -7, 3.4), (0.1, 0.1, 0.55)).data.lens = 34 / 4
    frame(4)
    if part("style").load(name).color.blacks > 0:
        new_object(bpy.data.lights.new("Sun", "SUN"), "Sun").rotation_euler = (0.75, 0.25, 0.6)
    use_style(bpy.context.scene, name)


def tiles():
    """A square of four tiles of two materials in turn; marked lines across the tiles in front."""
    grid = [(x * 0.8, y * 0.8, 0) for y in range(-3, 4) for x in range(-3, 4)]
    quads = [(i, i + 1, i + 8, i + 7) for i in range(41) if i % 7 < 6]
    mesh = new_mesh(grid, [], quads, "Tiles")
    for name in ("Light", "Dark"):
        mesh.materials.append(bpy.data.materials.new(name))
    mesh.polygons.foreach_set("material_index", [(i // 3 + i // 18) % 2 for i in range(36)])
    mark_edges(mesh, freestyle=[e.index for e in mesh.edges if {v // 7 for v in e.vertices} == {1}])
    return mesh


def orthographic():
    """Text, a curve, instances of a collection and a holdout before no paper, in parallel projection."""
    lettering = bpy.data.curves.new("Text", "FONT")
    lettering.body, lettering.extrude, lettering.size = "Fovea", 0.1, 1.1
    new_object(lettering, "Text", (-3.1, -0.6, 0)).rotation_euler.x = math.pi / 2
    new_object(ring(), "Curve", (1.9, 0.3, 0.9))
    instances()
    hole = new_object(box_mesh(0.35), "Hole", (-0.2, -1.5, 0.4))
    hole.is_holdout = True
    camera = add_camera((4, -9, 5), (-0.1, 0.6, 0.8))
    camera.data.type, camera.data.ortho_scale = "ORTHO", 6.8
    bpy.context.scene.render.film_transparent = True
    frame()


def ring():
    """A closed Bezier curve with a round bevel."""
    bpy.ops.curve.primitive_bezier_circle_add(radius=0.8)
    made = bpy.context.object.data
    bpy.data.objects.remove(bpy.context.object)
    made.bevel_depth, made.bevel_resolution = 0.15, 6
    return made


def instances():
    """Three of a collection of a box on a box, each turned further."""
    tower = bpy.data.collections.new("Tower")
    new_object(box_mesh(0.4), "Foot", (0, 0, 0.4), tower)
    new_object(box_mesh(0.25), "Top", (0, 0, 1.05), tower)
    for number in range(3):
        placed = new_object(None, "Instance", (-2.6 + 1.5 * number, 1.6, 0.3 * number))
        placed.instance_type, placed.instance_collection = "COLLECTION", tower
        placed.rotation_euler.z = 0.3 * number


def frame(zoom=1):
    """A small picture: the whole, or the middle of one that is `zoom` times as large."""
    render = bpy.context.scene.render
    render.resolution_x, render.resolution_y, render.resolution_percentage = WIDTH * zoom, HEIGHT * zoom, 100
    render.use_border = render.use_crop_to_border = zoom > 1
    render.border_min_x = render.border_min_y = 0.5 - 0.5 / zoom
    render.border_max_x = render.border_max_y = 0.5 + 0.5 / zoom


def draw(path):
    """Renders the open scene to a PNG file: the same picture on every machine, and nothing else in the file."""
    scene = bpy.context.scene
    for stamp in (name for name in scene.render.bl_rna.properties.keys() if name.startswith("use_stamp")):
        setattr(scene.render, stamp, False)
    image = scene.render.image_settings
    scene.render.engine, scene.render.dither_intensity = "FOVEA", 0
    scene.view_settings.view_transform = "Standard"
    scene.fovea.backend, scene.fovea.visibility = "CPU", "EXACT"
    image.file_format, image.color_mode, image.color_depth, image.compression = "PNG", "RGBA", "8", 100
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)


SCENES = {
    "demo": lambda: named("demo"),
    "boxes_10": lambda: named("boxes:10"),
    "suzanne_2": lambda: named("suzanne:2"),
    "orthographic": orthographic,
    **{name: partial(model, path) for name, path in MODELS.items()},
    **{f"style_{name}": partial(styled, name) for name in part("style").names()},
}


def build(name):
    """In an empty file."""
    empty_scene()
    SCENES[name]()
