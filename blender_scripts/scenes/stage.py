# SPDX-License-Identifier: GPL-3.0-or-later
"""Setup shared by all scenes: an empty file, a camera, light, materials, render settings."""

import math

import bpy
from mathutils import Vector


def need(version, what):
    """ValueError where this Blender is older than `version`, (4, 3) for example, which has `what` first."""
    if bpy.app.version < version:
        since = ".".join(map(str, version))
        raise ValueError(f"{what} needs Blender {since} or later, and this is {bpy.app.version_string}")


def clear():
    """Removes all data instead of loading an empty file, which would disable add-ons."""
    blocks = [
        bpy.data.objects,
        bpy.data.collections,
        bpy.data.meshes,
        bpy.data.curves,
        bpy.data.metaballs,
        bpy.data.cameras,
        bpy.data.lights,
        bpy.data.materials,
    ]
    bpy.data.batch_remove([block for kind in blocks for block in kind])


def frame():
    """Sets 1920 x 1080 pixels, a white world and the Standard view transform; AgX would make white paper gray."""
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = 1920, 1080
    scene.render.resolution_percentage = 100
    scene.view_settings.view_transform = "Standard"
    scene.frame_start = scene.frame_end = 1
    scene.world = scene.world or bpy.data.worlds.new("World")
    scene.world.color = (1, 1, 1)
    scene.display.shading.light = "STUDIO"
    scene.display.shading.color_type = "MATERIAL"


def link(name: str, data):
    """A new object in the scene."""
    made = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(made)
    return made


def camera(location, target, lens: float = 50.0, shift: tuple[float, float] = (0, 0)):
    data = bpy.data.cameras.new("Camera")
    data.lens = lens
    data.shift_x, data.shift_y = shift
    data.clip_start, data.clip_end = 0.1, 500
    made = link("Camera", data)
    made.location = location
    made.rotation_euler = (Vector(target) - Vector(location)).to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.camera = made
    return made


def sun(azimuth: float, elevation: float, strength: float = 3.0):
    """Adds a sun in the given direction, degrees; azimuth 0 is +x, 90 is +y."""
    data = bpy.data.lights.new("Sun", "SUN")
    data.energy = strength
    made = link("Sun", data)
    made.rotation_euler = (math.radians(90 - elevation), 0, math.radians(azimuth + 90))
    return made


def material(name: str, color: tuple[float, float, float]):
    """The material of that name, created on first use; `color`: scene-linear, for the viewport and for its shader."""
    found = bpy.data.materials.get(name)
    if found:
        return found
    made = bpy.data.materials.new(name)
    made.diffuse_color = (*color, 1)
    made.roughness = 0.8
    if made.node_tree is None:  # from 5.0 on every material has nodes, and the switch is deprecated
        made.use_nodes = True
    shader = made.node_tree.nodes.get("Principled BSDF")
    if shader:
        shader.inputs["Base Color"].default_value = made.diffuse_color
        shader.inputs["Roughness"].default_value = made.roughness
    return made
