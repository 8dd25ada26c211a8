# SPDX-License-Identifier: GPL-3.0-or-later
"""`api.drawing`, by which other add-ons get a drawing as the text of an SVG file."""

import xml.etree.ElementTree as ElementTree

import bpy
import pytest
from pictures import box_scene
from the_addon import add_camera, new_object, part

api, style, CannotDraw = part("render.api"), part("style"), part("scene.problem").CannotDraw
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture
def scene():
    return box_scene()


def paths(svg):
    """Those of visible lines."""
    found = ElementTree.fromstring(svg).iter(f"{SVG}path")
    return [path for path in found if not path.get("data-invisibility")]


def test_is_what_the_operator_writes_of_the_scene(scene, tmp_path):
    file = tmp_path / "box.svg"
    bpy.ops.fovea.export_vectors(filepath=str(file), sheet="a4")
    assert api.drawing(sheet="a4") == file.read_text() == api.drawing(scene.camera, sheet="a4")


def test_another_camera_and_style_draw_it_and_the_scene_stays_as_it_is(scene):
    before, own = scene.camera, scene.fovea.style
    above = add_camera((0, 0, 9))
    scene.camera = before
    marker = scene.timeline_markers.new("cut", frame=scene.frame_current)
    marker.camera = before
    from_above, from_before = api.drawing(above), api.drawing()
    assert len(paths(from_above)) < len(paths(from_before))  # of the box one side alone
    thick = style.load("plain")
    thick = thick.replace(line_sets=[s.replace(pen=s.pen.replace(width=40.0)) for s in thick.line_sets])
    widths = {float(path.get("stroke-width", 0)) for path in paths(api.drawing(style=thick, widths="center"))}
    assert min(widths) > 5
    assert api.drawing(style="plain") == api.drawing(style=style.load("plain")) != from_before
    assert (scene.camera, scene.fovea.style, marker.camera) == (before, own, before)
    assert api.drawing() == from_before and len(bpy.data.scenes) == 1


def test_draws_scenes_of_other_engines(scene):
    expected = api.drawing()
    scene.render.engine = "BLENDER_WORKBENCH"
    assert api.drawing() == expected and scene.render.engine == "BLENDER_WORKBENCH"


def test_what_cannot_be_drawn_is_told(scene):
    with pytest.raises(ValueError, match="there is no style 'nonsense'"):
        api.drawing(style="nonsense")
    with pytest.raises(ValueError, match="margin is -1"):
        api.drawing(margin=-1.0)
    with pytest.raises(TypeError, match="no 'sheets'"):
        api.drawing(sheets="a4")
    away = new_object(bpy.data.cameras.new("Away"), "Away")
    scene.collection.objects.unlink(away)
    with pytest.raises(CannotDraw, match="'Away' is not in the scene"):
        api.drawing(away)
    scene.camera = None
    with pytest.raises(CannotDraw, match="camera"):
        api.drawing()
