# SPDX-License-Identifier: GPL-3.0-or-later
"""Filters of line sets follow what is renamed, and bring nothing along into other files."""

import bpy
import pytest
from the_addon import box_mesh, empty_scene, lines_of, new_object, part, use_style

renamed, style = part("style.renamed"), part("style")
KINDS = renamed.KINDS


@pytest.fixture
def scene():
    scene = empty_scene()
    use_style(scene, "plain")
    thing = new_object(box_mesh(), "Thing")
    thing.data.materials.append(bpy.data.materials.new("Thing"))
    scene.collection.children.link(bpy.data.collections.new("Thing"))
    return scene


def told():
    """Blender tells of changes at the end of an operator or a script; here none has an end."""
    bpy.context.view_layer.update()
    renamed.follow()


@pytest.mark.parametrize("kind", sorted(style.FILTERS))
def test_a_filter_follows_what_is_renamed(scene, kind):
    line_set, thing = lines_of(scene), getattr(bpy.data, KINDS[kind])["Thing"]
    setattr(line_set, kind, "Thing")
    told()
    thing.name = "Other"
    told()
    assert getattr(line_set, kind) == "Other"
    thing.name = "Thing"
    told()
    assert getattr(line_set, kind) == "Thing"


def test_two_that_change_their_names_are_told_apart(scene):
    other = new_object(box_mesh(), "Other")
    lines_of(scene).object = "Thing"
    told()
    thing = bpy.data.objects["Thing"]
    other.name, thing.name, other.name = "Between", "Other", "Thing"
    told()
    assert lines_of(scene).object == "Other"


def test_a_name_that_nothing_has_stays_and_so_does_that_of_what_is_gone(scene):
    line_set = lines_of(scene)
    line_set.collection, line_set.object = "Not yet there", "Thing"
    told()
    bpy.data.objects.remove(bpy.data.objects["Thing"])
    new_object(box_mesh(), "Another")
    told()
    assert (line_set.collection, line_set.object) == ("Not yet there", "Thing")
    new_object(box_mesh(), "Thing").name = "Renamed"
    told()
    assert line_set.object == "Thing", "another object that had this name meanwhile"


def test_an_appended_style_brings_no_objects_along(scene, tmp_path):
    line_set = lines_of(scene)
    line_set.object = line_set.collection = line_set.material = "Thing"
    told()
    path = str(tmp_path / "styles.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path, copy=True)
    name = scene.fovea.style.name
    empty_scene()
    for kind in KINDS.values():
        while getattr(bpy.data, kind):
            getattr(bpy.data, kind).remove(getattr(bpy.data, kind)[0])
    with bpy.data.libraries.load(path, link=False) as (_, wanted):
        wanted.node_groups = [name]
    assert not any(getattr(bpy.data, kind) for kind in KINDS.values())
    assert wanted.node_groups[0].fovea.line_sets[-1].object == "Thing"
