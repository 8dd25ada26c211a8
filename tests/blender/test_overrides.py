# SPDX-License-Identifier: GPL-3.0-or-later
"""Styles and settings that are linked from another file, and library overrides of them."""

import bpy
import numpy as np
import pytest
from pictures import box_scene, drawn
from the_addon import empty_scene, part

style, style_data, style_read = part("style"), part("style.style_data"), part("style.style_read")
properties = part("render.properties")


@pytest.fixture
def library(tmp_path):
    """A file with a scene, whose object "Box" has no settings, and its style "Rich" with a bent pen; its picture."""
    scene = box_scene()
    bent = style.Transfer(curve=((0.0, 0.0), (0.5, 1.0), (1.0, 0.5)))
    pen = style.Pen(width=20.0, nib_width=0.5, along_width=bent)
    kinds = {"contour": {}, "crease": {}}
    tree = style_data.new("Rich", style.Style(line_sets=(style.LineSet(name="all", kinds=kinds, pen=pen),)))
    style_data.assign(scene, tree)
    picture = drawn(scene, tmp_path / "library.png")
    path = tmp_path / "library.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path, picture


def link(path, **wanted):
    with bpy.data.libraries.load(str(path), link=True) as (_, into):
        for kind, names in wanted.items():
            setattr(into, kind, names)


def reopened(tmp_path, times=2):
    """The scene of the file after it was saved and opened again so many times."""
    for number in range(times):
        path = str(tmp_path / f"user{number}.blend")
        bpy.ops.wm.save_as_mainfile(filepath=path)
        bpy.ops.wm.open_mainfile(filepath=path)
    return bpy.context.scene


def test_a_linked_style_draws_as_in_its_file(library, tmp_path):
    path, expected = library
    scene = box_scene()
    link(path, node_groups=["Rich"])
    scene.fovea.style = bpy.data.node_groups["Rich"]
    np.testing.assert_array_equal(drawn(scene, tmp_path / "linked.png"), expected)


def test_a_linked_scene_draws_as_in_its_file(library, tmp_path):
    path, expected = library
    empty_scene()
    link(path, scenes=["Scene"])
    scene = next(scene for scene in bpy.data.scenes if scene.library)
    bpy.context.window.scene = scene
    np.testing.assert_array_equal(drawn(scene, tmp_path / "linked.png"), expected)


def test_an_override_of_a_style_keeps_what_it_changes(library, tmp_path):
    path, _ = library
    scene = box_scene()
    link(path, node_groups=["Rich"])
    before = style_read.read(bpy.data.node_groups["Rich"])
    tree = scene.fovea.style = bpy.data.node_groups["Rich"].override_create()
    held = tree.fovea
    held.line_sets[0].pen.width, held.line_sets[0].pen.noise_width, held.paper.tooth = 7.5, 0.5, 0.25
    held.line_sets[0].pen.along_width.strength, held.line_sets[0].kinds.valley = 0.75, True
    scene = reopened(tmp_path)
    tree = scene.fovea.style
    assert tree.override_library and not tree.library
    (line_set,) = style_read.read(tree).line_sets
    (was,) = before.line_sets
    bent = was.pen.along_width.replace(strength=0.75)
    assert line_set.pen == was.pen.replace(width=7.5, noise_width=0.5, along_width=bent)
    assert set(line_set.kinds) == {*was.kinds, "valley"} and style_read.read(tree).paper.tooth == 0.25


def test_an_override_follows_its_library_in_all_else(library, tmp_path):
    path, _ = library
    scene = box_scene()
    link(path, node_groups=["Rich"])
    tree = scene.fovea.style = bpy.data.node_groups["Rich"].override_create()
    tree.fovea.line_sets[0].pen.width = 7.5
    user = str(tmp_path / "user.blend")
    bpy.ops.wm.save_as_mainfile(filepath=user)
    bpy.ops.wm.open_mainfile(filepath=str(path))
    bpy.data.node_groups["Rich"].fovea.line_sets[0].pen.opacity = 0.5
    bpy.ops.wm.save_mainfile()
    bpy.ops.wm.open_mainfile(filepath=user)
    pen = bpy.context.scene.fovea.style.fovea.line_sets[0].pen
    assert (pen.width, pen.opacity) == (7.5, 0.5)


def test_an_override_of_a_style_keeps_line_sets_and_hidden_pens_that_are_added_and_refuses_the_rest(library, tmp_path):
    scene = box_scene()
    link(library[0], node_groups=["Rich"])
    scene.fovea.style = bpy.data.node_groups["Rich"].override_create()
    scene.fovea.style.fovea.line_set_index = 0
    for name in ("line_set_add", "hidden_pen_add"):
        assert getattr(bpy.ops.fovea, name)() == {"FINISHED"}
    for name in ("line_set_duplicate", "line_set_move", "line_set_remove", "hidden_pen_remove", "pen_curve_add"):
        assert not getattr(bpy.ops.fovea, name).poll(), name
    expected = style_read.read(scene.fovea.style)
    assert len(expected.line_sets) == 2 and [len(s.hidden) for s in expected.line_sets] == [1, 0]
    assert style_read.read(reopened(tmp_path).fovea.style) == expected


def test_an_override_of_an_object_keeps_settings_that_the_library_never_had(library, tmp_path):
    scene = box_scene()
    bpy.data.objects.remove(scene.objects["Box"])
    link(library[0], objects=["Box"])
    box = bpy.data.objects["Box"].override_create()
    scene.collection.objects.link(box)
    box.fovea.usage, box.fovea.own_kinds, box.fovea.kinds.crease, box.fovea.outline_group = "DRAW", True, False, "A"
    scene = reopened(tmp_path)
    box = next(obj for obj in scene.objects if obj.name == "Box")
    found = box.fovea.usage, box.fovea.own_kinds, box.fovea.kinds.crease, box.fovea.outline_group
    assert box.override_library and found == ("DRAW", True, False, "A")
