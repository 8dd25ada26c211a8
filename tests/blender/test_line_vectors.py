# SPDX-License-Identifier: GPL-3.0-or-later
"""Line vectors: how lines move between frames, beside the vectors of surfaces that Cycles has, and in closed form."""

import addon_utils
import bpy
import numpy as np
import pytest
from pictures import drawn, layered
from test_passes import layers_node, new_compositor
from the_addon import add_camera, box_mesh, empty_scene, new_mesh, new_object, only_lines, part, use_style

SIZE = (320, 240)
FRAME = 5
session = part("render.session")


def keyed(owner, name, values):
    """Keys a property of an owner steadily: values at the frame before, at `FRAME`, and at the one after it."""
    for frame, value in zip((FRAME - 1, FRAME, FRAME + 1), values):
        setattr(owner, name, value)
        owner.keyframe_insert(name, frame=frame)


def scene_of(camera=(5, -7, 4)):
    scene = empty_scene()
    add_camera(camera)
    scene.render.resolution_x, scene.render.resolution_y = SIZE
    scene.render.use_motion_blur = False
    style = use_style(scene, "plain")
    style.elision.enabled = False
    scene.view_layers[0].fovea.line_vector = scene.view_layers[0].fovea.line_depth = True
    return scene


def passes(scene, path, engine="FOVEA"):
    scene.render.engine = engine
    scene.frame_set(FRAME)
    return layered(scene, path)


def vectors(channels, name="LineVector"):
    """(H, W, 4) pixels: from where it was, and to where it will be."""
    return np.stack([channels[f"ViewLayer.{name}.{letter}"] for letter in "XYZW"], axis=-1)


def a_sheet():
    """A grid of 12 x 12 faces that a shape key bends."""
    at = [(x / 6 - 1, y / 6 - 1, 0.0) for y in range(13) for x in range(13)]
    faces = [(13 * y + x, 13 * y + x + 1, 13 * y + x + 14, 13 * y + x + 13) for y in range(12) for x in range(12)]
    sheet = new_object(new_mesh(at, [], faces), "Sheet", (-1.5, 1.5, 0.5))
    sheet.shape_key_add(name="Flat")
    bent = sheet.shape_key_add(name="Bent")
    for point, (x, y, _) in zip(bent.data, at):
        point.co = (x, y, x * x + 0.5 * y * y)
    keyed(bent, "value", (0.3, 0.34, 0.4))


def moving_things():
    """A box that moves and turns, and a sheet that bends, before a camera that moves."""
    scene = scene_of()
    box = new_object(box_mesh(0.8), "Box", (1.2, 0, 0))
    keyed(box, "location", ((1.0, 0, 0), (1.2, 0.1, 0), (1.5, 0.1, 0.1)))
    keyed(box, "rotation_euler", ((0.5, 0, 0.48), (0.51, 0, 0.5), (0.51, 0.01, 0.53)))
    a_sheet()
    keyed(scene.camera, "location", ((4.9, -7, 4), (5, -7, 4), (5, -6.8, 4.1)))
    only_lines(scene, "crease", "border")
    return scene


def test_they_are_those_that_cycles_has_of_the_surfaces_at_lines_of_the_mesh(tmp_path):
    if addon_utils.enable("cycles") is None:
        pytest.skip("this Blender has no Cycles")
    scene = moving_things()
    of_lines = passes(scene, tmp_path / "lines.exr")
    layer = scene.view_layers[0]
    layer.use_pass_vector = layer.use_pass_z = True
    scene.cycles.device, scene.cycles.samples, scene.cycles.use_denoising = "CPU", 1, False
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BOX", 0.01
    of_surfaces = passes(scene, tmp_path / "surfaces.exr", "CYCLES")
    found, known = vectors(of_lines), vectors(of_surfaces, "Vector")
    depth = of_surfaces[next(name for name in of_surfaces if name.startswith("ViewLayer.Depth."))]
    of_line = of_lines["ViewLayer.LineDepth.Z"]
    on_it = (of_line < 1e9) & (np.abs(of_line / depth - 1) < 0.002)
    assert on_it.sum() > 500 and (np.abs(known[on_it]).max(axis=0) > 2).all()
    apart = np.abs(found - known)[on_it]
    # Lines tell of their own nearest point, up to a pixel from the middle of the pixel, over which motion changes.
    assert apart.max() < 0.15 and np.median(apart) < 0.02
    assert not found[of_line > 1e9].any()


@pytest.fixture
def box():
    """A scene of a box that moves to the right."""
    scene = scene_of()
    keyed(new_object(box_mesh(), "Box"), "location", ((-0.3, 0, 0), (0, 0, 0), (0.2, 0, 0)))
    only_lines(scene, "crease", "contour")
    return scene


def test_a_picture_with_them_is_the_one_without_to_the_last_bit(box, tmp_path):
    box.view_layers[0].fovea.line_vector = False
    without = passes(box, tmp_path / "without.exr")
    assert not any("LineVector" in name for name in without)
    box.view_layers[0].fovea.line_vector = True
    found = passes(box, tmp_path / "with.exr")
    assert vectors(found).any() and all((found[name] == pixels).all() for name, pixels in without.items())


def test_other_frames_are_read_for_them_alone(box, tmp_path, monkeypatch):
    read, pose = [], session._pose

    def reading(engine, depsgraph, *arguments):
        read.append(depsgraph.scene.frame_current)
        return pose(engine, depsgraph, *arguments)

    monkeypatch.setattr(session, "_pose", reading)
    passes(box, tmp_path / "with.exr")
    assert read == [FRAME - 1, FRAME + 1] and box.frame_current == FRAME
    box.view_layers[0].fovea.line_vector = False
    passes(box, tmp_path / "without.exr")
    assert len(read) == 2


def test_beyond_a_change_of_the_camera_lines_do_not_move(box, tmp_path):
    other = new_object(bpy.data.cameras.new("Other"), "Other", (0, -9, 0))
    for frame, camera in ((1, box.camera), (FRAME + 1, other)):
        box.timeline_markers.new("camera", frame=frame).camera = camera
    found = vectors(passes(box, tmp_path / "cut.exr"))
    assert found[..., :2].any() and not found[..., 2:].any()


def test_in_a_part_of_the_picture_they_are_those_of_the_whole(box, tmp_path):
    whole = vectors(passes(box, tmp_path / "whole.exr"))
    render = box.render
    render.use_border = render.use_crop_to_border = True
    render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y = 0.25, 0.75, 0.25, 0.75
    part_of_it = vectors(passes(box, tmp_path / "part.exr"))
    height, width = part_of_it.shape[:2]
    assert (width, height) == (SIZE[0] // 2, SIZE[1] // 2) and part_of_it.any()
    np.testing.assert_allclose(part_of_it, whole[60 : 60 + height, 80 : 80 + width], atol=1e-3)


def test_blenders_vector_blur_smears_lines_along_them(box, tmp_path):
    box.render.engine = "FOVEA"
    box.frame_set(FRAME)
    box.view_settings.view_transform, box.render.dither_intensity = "Raw", 0.0
    tree, output = new_compositor(box)
    layers, blur = layers_node(tree, box), tree.nodes.new("CompositorNodeVecBlur")
    for name, socket in (("Lines", 0), ("LineVector", "Speed"), ("LineDepth", "Z")):
        tree.links.new(layers.outputs[name], blur.inputs[socket])
    pictures = {}
    for source in (layers.outputs["Lines"], blur.outputs[0]):
        tree.links.new(source, output.inputs[0])
        pictures[source.node] = drawn(box, tmp_path / "blurred.png")[..., 3]
    sharp, blurred = pictures[layers], pictures[blur]
    # All edges move to the right by 8 to 14 pixels from frame to frame: those upright are smeared over half of that.
    row = slice(SIZE[1] // 2 - 2, SIZE[1] // 2 + 2)
    assert (blurred[row] > 0.02).sum() > 2.5 * (sharp[row] > 0.02).sum()
    assert blurred[row].max() < 0.6 * sharp[row].max()
