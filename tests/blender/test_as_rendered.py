# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators use the scene as a final render evaluates it, not as viewports do, and leave no trace of the render."""

from contextlib import suppress

import bpy
import numpy as np
import pytest
from pictures import SIZE, box_scene, layered
from the_addon import add_camera, box_mesh, new_object, part, use_style

as_rendered, report = part("render.as_rendered"), part("render.report")


@pytest.fixture
def scene():
    scene = box_scene()
    style = use_style(scene, "plain")
    style.line_sets[-1].pen.width, style.elision.enabled = 12.0, False
    return scene


def subdivided(obj, levels, render_levels):
    modifier = obj.modifiers.new("Subdivision", "SUBSURF")
    modifier.levels, modifier.render_levels = levels, render_levels
    return obj


def lines_alpha():
    """(H, W) alpha of the image that the operator makes."""
    assert bpy.ops.fovea.render_lines(name="Lines") == {"FINISHED"}
    image = bpy.data.images["Lines"]
    pixels = np.empty(4 * SIZE[0] * SIZE[1], np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(*SIZE[::-1], 4)[..., 3]


def rendered_alpha(scene, tmp_path):
    """The same of the pass of a final render."""
    channels = layered(scene, tmp_path / "layers.exr")
    return next(values for name, values in channels.items() if "Lines" in name and name.endswith("A"))


def same(a, b):
    return np.abs(a - b).max() < 2e-3


def without_render_levels(scene):
    subdivided(scene.objects["Box"], 0, 2)


def hidden_in_renders(scene):
    new_object(box_mesh(), "Other", (2, 0, 0)).hide_render = True


def hidden_in_viewports(scene):
    new_object(box_mesh(), "Other", (2, 0, 0)).hide_viewport = True


def hidden_by_its_eye(scene):
    other = new_object(box_mesh(), "Other", (2, 0, 0))
    bpy.context.view_layer.update()
    other.hide_set(True)


def in_a_later_frame(scene):
    box = scene.objects["Box"]
    box.keyframe_insert("location", frame=1)
    box.location.x = 2
    box.keyframe_insert("location", frame=9)
    scene.frame_set(5)


def with_modifiers_of_renders_alone(scene):
    array = scene.objects["Box"].modifiers.new("Array", "ARRAY")
    array.relative_offset_displace[0] = 1.5
    array.show_viewport = False


CASES = (
    *(without_render_levels, hidden_in_renders, hidden_in_viewports, hidden_by_its_eye, in_a_later_frame),
    with_modifiers_of_renders_alone,
)


@pytest.mark.parametrize("change", CASES, ids=lambda change: change.__name__)
def test_lines_are_those_of_the_final_render(scene, tmp_path, change):
    plain = lines_alpha()
    change(scene)
    bpy.context.view_layer.update()
    found = lines_alpha()
    assert same(found, rendered_alpha(scene, tmp_path))
    assert same(found, plain) == (change is hidden_in_renders)


def test_elision_smoothed_in_time_is_too(scene, tmp_path):
    elision = part("style.style_data").own(scene).elision
    elision.enabled, elision.frames = True, 1
    in_a_later_frame(scene)
    for step in range(6):
        new_object(box_mesh(0.9), f"Sheet{step}", (0, 0, 1.5 + 0.05 * step))
    assert same(lines_alpha(), rendered_alpha(scene, tmp_path))


def test_the_view_layer_is_the_one_in_use(scene):
    hidden = bpy.data.collections.new("Hidden")
    scene.collection.children.link(hidden)
    new_object(box_mesh(), "Other", (2, 0, 0), hidden)
    with_other, without = scene.view_layers[0], scene.view_layers.new("Without")
    without.layer_collection.children["Hidden"].exclude = True
    without.use = False  # not rendered by F12, but it is what one looks at
    alphas = []
    for layer in (with_other, without):
        with bpy.context.temp_override(view_layer=layer):
            alphas.append(lines_alpha())
    assert alphas[1].sum() < 0.8 * alphas[0].sum() and not without.use


def test_baked_strokes_are_those_of_the_render(scene):
    without_render_levels(scene)
    new_object(box_mesh(), "Other", (4, 0, 0)).hide_render = True
    bpy.context.view_layer.update()
    assert bpy.ops.fovea.bake_strokes(kind="MESH") == {"FINISHED"}
    points = np.array([v.co for v in bpy.data.collections["Lines"].objects[0].data.vertices])
    # Twice subdivided, nothing of a box comes as far as its corners, and what is disabled is not there.
    assert 0.3 < np.linalg.norm(points, axis=1).max() < 1.3


def test_the_report_is_of_the_render(scene):
    hidden_in_renders(scene)
    new_object(box_mesh(), "Shown", (2, 0, 0)).hide_viewport = True
    away = bpy.data.collections.new("Away")
    scene.collection.children.link(away)
    new_object(box_mesh(), "Elsewhere", (2, 0, 0), away)
    bpy.context.view_layer.layer_collection.children["Away"].exclude = True
    off = bpy.data.collections.new("Off")
    scene.collection.children.link(off)
    new_object(box_mesh(), "InCollection", (2, 0, 0), off)
    off.hide_render = True
    bpy.context.view_layer.update()
    bpy.ops.fovea.report()
    text = bpy.data.texts[report.TEXT].as_string()
    assert "'Other': is disabled in renders" in text and "'Shown'" not in text
    assert "'Elsewhere': is not in the view layer 'ViewLayer'" in text
    assert "'InCollection': is in a collection that is disabled in renders" in text
    assert "objects and instances: 2," in text


def test_pictures_in_other_slots_stay(scene, tmp_path):
    scene.render.engine = "BLENDER_WORKBENCH"
    bpy.ops.render.render()
    result = next(image for image in bpy.data.images if image.type == "RENDER_RESULT")
    slots = result.render_slots

    def pictures():
        found = []
        for i in range(len(slots)):
            slots.active_index = i
            path = tmp_path / "slot.png"
            path.unlink(missing_ok=True)
            with suppress(RuntimeError):  # nothing in it
                result.save_render(str(path), scene=scene)
            found.append(path.read_bytes() if path.exists() else None)
        slots.active_index = 1
        return found

    slots.active_index = 1
    next(obj for obj in scene.objects if obj.type == "MESH").location.x += 0.5
    bpy.ops.render.render()
    before = pictures()
    assert sum(picture is not None for picture in before) == 2 and before[0] != before[1]
    for _ in range(2):
        assert bpy.ops.fovea.render_lines() == {"FINISHED"} and bpy.ops.fovea.bake_strokes() == {"FINISHED"}
    assert pictures() == before


def test_nothing_is_left_of_the_render(scene, tmp_path):
    settings = scene.render
    settings.engine, settings.use_compositing, settings.use_sequencer = "BLENDER_WORKBENCH", True, True
    settings.filepath = str(tmp_path / "not_written.png")
    bpy.ops.render.render()
    result = next(image for image in bpy.data.images if image.type == "RENDER_RESULT")
    shown = tmp_path / "before.png", tmp_path / "after.png"
    result.save_render(str(shown[0]), scene=scene)
    slot, slots = result.render_slots.active_index, len(result.render_slots)
    assert bpy.ops.fovea.render_lines() == {"FINISHED"} and bpy.ops.fovea.report() == {"FINISHED"}
    result.save_render(str(shown[1]), scene=scene)
    assert shown[0].read_bytes() == shown[1].read_bytes()
    assert result.render_slots.active_index == slot and len(result.render_slots) == slots
    assert (settings.engine, settings.use_compositing, settings.use_sequencer) == ("BLENDER_WORKBENCH", True, True)
    assert not (tmp_path / "not_written.png").exists()
    assert bpy.ops.render.render() == {"FINISHED"}


def test_what_goes_wrong_is_told_and_ends_it(scene):
    def fail(engine, depsgraph):
        raise part("scene.problem").CannotDraw("so it is")

    with pytest.raises(part("scene.problem").CannotDraw, match="so it is"):
        as_rendered.look(bpy.context, fail)
    scene.camera.data.type = "PANO"
    with pytest.raises(RuntimeError, match="panoramic"):
        bpy.ops.fovea.render_lines()
    bpy.data.objects.remove(scene.camera)
    add_camera()
    assert lines_alpha().max() > 0.9


def test_both_eyes_of_a_stereo_pair_are_one_look(scene):
    scene.render.use_multiview = True
    looks = []
    as_rendered.look(bpy.context, lambda engine, depsgraph: looks.append(engine.active_view_get()))
    assert len(looks) == 1
