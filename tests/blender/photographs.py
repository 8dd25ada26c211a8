# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene whose render is known in closed form: a white sphere between two white boxes before a black sky, without
shading. The camera looks along y at the sphere's center."""

import addon_utils
import bpy
import numpy as np
import pytest
from long_tests import IS_LONG
from pictures import drawn
from the_addon import add_camera, box_mesh, empty_scene, new_object, only_lines, part, shader_material, use_style

SIZE = (200, 100)
AWAY, RADIUS, HALF, ASIDE = 10.0, 1.2, 0.6, 2.4  # of the camera; of the sphere; of a box, and its place
FOCAL = SIZE[0] * 50 / 36  # pixels
MIDDLE = np.array(SIZE) / 2
ENGINES = ("CYCLES", "BLENDER_WORKBENCH")
EEVEE = "BLENDER_EEVEE" if bpy.app.version >= (5, 0, 0) else "BLENDER_EEVEE_NEXT"
lines_over = part("render.lines_over")


def photograph(engine):
    """The scene, without lines. Skips the test where this Blender cannot render it here."""
    scene = empty_scene()
    if engine == "CYCLES" and addon_utils.enable("cycles") is None:
        pytest.skip("this Blender has no Cycles")
    if engine != "CYCLES" and part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    if engine == EEVEE and not IS_LONG:
        pytest.skip("EEVEE compiles its shaders for a minute on software OpenGL: fovea test --long does")
    white = shader_material("White", "ShaderNodeEmission")
    white.diffuse_color = white.node_tree.nodes["Emission"].inputs["Color"].default_value = (1, 1, 1, 1)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=128, ring_count=64, radius=RADIUS)
    sphere = bpy.context.object
    sphere.data.shade_smooth()
    boxes = [new_object(box_mesh(HALF), "Box", (side * ASIDE, 0, 0)) for side in (-1, 1)]
    for obj in (sphere, *boxes):
        obj.data.materials.append(white)
    add_camera((0, -AWAY, 0))
    render = scene.render
    render.engine, render.resolution_x, render.resolution_y = engine, *SIZE
    render.dither_intensity, scene.view_settings.view_transform = 0.0, "Raw"
    scene.world = bpy.data.worlds.new("World")
    scene.world.use_nodes = True
    scene.world.color = scene.world.node_tree.nodes["Background"].inputs["Color"].default_value[:3] = (0, 0, 0)
    if engine == "CYCLES":
        scene.cycles.device, scene.cycles.samples, scene.cycles.use_denoising = "CPU", 64, False
        scene.cycles.use_adaptive_sampling, scene.cycles.filter_width = False, 0.01
        scene.cycles.pixel_filter_type = "BOX"
    if engine == EEVEE:
        scene.eevee.taa_render_samples, scene.eevee.use_shadows, render.filter_size = 16, False, 1.0
    scene.display.shading.light, scene.display.shading.color_type = "FLAT", "MATERIAL"
    scene.display.render_aa = "32"
    red_lines(scene)
    return scene


def red_lines(scene):
    """The scene's style: red outlines of three pixels."""
    style = use_style(scene, "plain")
    only_lines(scene, "contour")
    style.elision.enabled = False
    for line_set in style.line_sets:
        pen = line_set.pen
        pen.color, pen.opacity, pen.texture = (1, 0, 0), 1.0, "solid"
        pen.width, pen.taper = 3.0 * 1080 / SIZE[1], 0.0


def parts(picture):
    """(coverage by the white objects where no line is, coverage by red lines) of a picture, each (H, W)."""
    red, green = picture[..., 0], picture[..., 1]
    return green, red - green


def with_lines(scene, path):
    """Coverage by lines of a picture of the scene, top row last."""
    return parts(drawn(scene, path))[1]


def outlines():
    """Yields (slice of a row or column, as index into a picture; position along it of an outline; whether the object
    lies before it) in closed form."""
    cone = FOCAL * RADIUS / np.sqrt(AWAY**2 - RADIUS**2)
    for offset in np.arange(-int(0.7 * cone), int(0.7 * cone)):
        half = np.sqrt(cone**2 - (offset + 0.5) ** 2)
        for side in (-1, 1):
            yield "row", int(MIDDLE[1] + offset), MIDDLE[0] + side * half, side > 0
            yield "column", int(MIDDLE[0] + offset), MIDDLE[1] + side * half, side > 0
    outer, inner = (ASIDE + HALF) / (AWAY - HALF), (ASIDE - HALF) / (AWAY + HALF)
    high = FOCAL * HALF / (AWAY - HALF)
    for offset in np.arange(-10, 10):
        for side in (-1, 1):
            yield "row", int(MIDDLE[1] + offset), MIDDLE[0] + side * FOCAL * outer, side > 0
            yield "row", int(MIDDLE[1] + offset), MIDDLE[0] + side * FOCAL * inner, side < 0
            yield "column", int(MIDDLE[0] + FOCAL * ASIDE / (AWAY - HALF) + offset), MIDDLE[1] + side * high, side > 0


def profile(picture, kind, index):
    return picture[index] if kind == "row" else picture[:, index]


def edge(coverage, at, before):
    """Where coverage crosses one half near a position, which is known to three pixels. `before`: the object lies below
    the position."""
    low, high = int(at) - 3, int(at) + 4
    covered = coverage[low:high].sum()
    return low + covered if before else high - covered


def middle(line, at):
    """The middle of a line near a position."""
    low, high = int(at) - 4, int(at) + 5
    weights = line[low:high]
    return (weights * (np.arange(low, high) + 0.5)).sum() / weights.sum()
