# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on styles and line sets: effects, undo, errors and messages."""

import json

import bpy
import pytest
from pictures import in_blender_without_room
from the_addon import empty_scene, lines_of, own_style, part, use_style

catalogue, properties, style = part("catalogue"), part("render.properties"), part("style")
files, registration = part("style.style_files"), part("scene.registration")


@pytest.fixture
def scene(tmp_path, monkeypatch):
    """The user's styles are in a folder of the test."""
    folder = tmp_path / "styles"
    folder.mkdir()
    monkeypatch.setattr(files, "user_folder", lambda create=False: folder)
    return empty_scene()


def drawn(scene):
    return properties.style_of(scene)


def test_new_makes_an_editable_copy_of_what_is_drawn(scene):
    before = drawn(scene)
    assert not bpy.ops.fovea.line_set_add.poll() and not bpy.ops.fovea.style_save.poll()
    assert bpy.ops.fovea.style_new(style=style.DEFAULT) == {"FINISHED"}
    assert [s.pen for s in drawn(scene).line_sets] == [s.pen for s in before.line_sets]
    assert bpy.ops.fovea.line_set_add.poll()


def test_a_style_is_saved_applied_and_deleted(scene):
    use_style(scene, "pencil")
    lines_of(scene).pen.width = 7.25
    saved = drawn(scene)
    assert bpy.ops.fovea.style_save(name="My  Own!") == {"FINISHED"}
    assert files.user_names() == ["my_own"]
    bpy.ops.fovea.style_apply(style="charcoal")
    assert drawn(scene) != saved and scene.fovea.style.name == "Charcoal"
    bpy.ops.fovea.style_apply(style="my_own")
    assert drawn(scene) == saved
    with pytest.raises(RuntimeError, match="ships with Fovea"):
        bpy.ops.fovea.style_save(name="Pencil")
    with pytest.raises(RuntimeError, match="letters or digits"):
        bpy.ops.fovea.style_save(name="../..")
    bpy.ops.fovea.style_delete(style="my_own")
    assert files.user_names() == [] and drawn(scene) == saved
    assert not bpy.ops.fovea.style_delete.poll()


def test_export_and_import_give_the_same_style(scene, tmp_path):
    use_style(scene, "watercolor").effects.fade.end = 0.625
    scene.fovea.focus_model, scene.fovea.focus_place = "IMAGE", (0.25, 0.5)
    exported, path = drawn(scene), str(tmp_path / "out.json")
    bpy.ops.fovea.style_export(filepath=path, with_focus=True, check_existing=False)
    scene = empty_scene()
    bpy.ops.fovea.style_import(filepath=path)
    assert drawn(scene) == exported and scene.fovea.focus_model == "IMAGE"
    bpy.ops.fovea.style_export(filepath=path, check_existing=False)
    assert not style.read(path).focus.active()


HOSTILE = {
    "not json": "{",
    "deep": "[" * 100000,
    "nan": '{"schema": 1, "line_sets": [{"pen": {"width": NaN}}]}',
    "huge": '{"schema": 1, "line_sets": [{"pen": {"width": 1e999}}]}',
    "wrong type": '{"schema": 1, "line_sets": {"pen": 3}}',
    "path": '{"schema": 1, "line_sets": [{"pen": {"texture": "../../etc/passwd"}}]}',
    "later": '{"schema": 99, "line_sets": [{}]}',
    "range": '{"schema": 1, "line_sets": [{"halo": 1e6}]}',
}


@pytest.mark.parametrize("words", HOSTILE.values(), ids=HOSTILE.keys())
def test_a_hostile_file_is_refused_in_a_sentence_and_nothing_changes(scene, tmp_path, words):
    use_style(scene, "pencil")
    before, trees = drawn(scene), len(bpy.data.node_groups)
    path = tmp_path / "styles" / "bad.json"
    path.write_text(words)
    calls = ((bpy.ops.fovea.style_import, {"filepath": str(path)}), (bpy.ops.fovea.style_apply, {"style": "bad"}))
    for call, given in calls:
        with pytest.raises(RuntimeError) as refused:
            call(**given)
        assert len(str(refused.value)) < 700 and "Traceback" not in str(refused.value)
        assert drawn(scene) == before and len(bpy.data.node_groups) == trees


def test_a_file_that_is_not_there_is_told(scene, tmp_path):
    with pytest.raises(RuntimeError, match="cannot be read"):
        bpy.ops.fovea.style_import(filepath=str(tmp_path / "none.json"))
    own_style(scene)
    for place, cause in ((tmp_path / "no" / "folder.json", "No such file"), (tmp_path / "styles", "Is a directory")):
        with pytest.raises(RuntimeError, match=f"{place}.* could not be written .{cause}"):
            bpy.ops.fovea.style_export(filepath=str(place), check_existing=False)


def test_a_style_that_a_full_disk_does_not_take_leaves_the_one_before(tmp_path):
    path, script = tmp_path / "out.json", tmp_path / "script.py"
    path.write_text("of an earlier run")
    script.write_text(
        "import bpy\n"
        "bpy.ops.fovea.style_new()\n"
        f"bpy.ops.fovea.style_export(filepath={str(path)!r}, check_existing=False)\n"
    )
    done = in_blender_without_room(["-P", str(script)])
    assert done.returncode == 1 and f"{path} could not be written (File too large)" in done.stderr
    assert sorted(tmp_path.iterdir()) == [path, script] and path.read_text() == "of an earlier run"


def names(scene):
    return [line_set.name for line_set in own_style(scene).line_sets]


def test_line_sets_are_added_copied_moved_and_removed(scene):
    held = use_style(scene, "technical")
    assert names(scene) == ["outline", "marks", "lines"]
    held.line_set_index = 0
    bpy.ops.fovea.line_set_duplicate()
    assert names(scene) == ["outline", "outline.001", "marks", "lines"] and held.line_set_index == 1
    first, second = drawn(scene).line_sets[:2]
    assert (first.kinds, first.pen, first.hidden) == (second.kinds, second.pen, second.hidden)
    bpy.ops.fovea.line_set_move(direction="DOWN")
    bpy.ops.fovea.line_set_move(direction="DOWN")
    bpy.ops.fovea.line_set_move(direction="DOWN")
    assert names(scene) == ["outline", "marks", "lines", "outline.001"] and held.line_set_index == 3
    bpy.ops.fovea.line_set_remove()
    bpy.ops.fovea.line_set_add()
    assert names(scene) == ["outline", "marks", "Line Set", "lines"] and held.line_set_index == 2
    for _ in range(3):
        bpy.ops.fovea.line_set_remove()
    assert names(scene) == ["outline"] and not bpy.ops.fovea.line_set_remove.poll()


@pytest.mark.parametrize("style", style.names())
def test_the_name_of_a_new_line_set_differs_from_all_others_in_more_than_capitals(scene, style):
    use_style(scene, style)
    for _ in range(2):
        bpy.ops.fovea.line_set_add()
        bpy.ops.fovea.line_set_duplicate()
    found = [name.lower() for name in names(scene)]
    assert len(set(found)) == len(found)


def test_a_new_line_set_is_as_the_edited_one_but_for_filters_and_hidden_pens(scene):
    held = use_style(scene, "pen_and_ink")
    source = held.line_sets[held.line_set_index]
    source.kinds.crease_angle, source.collection, source.outside, source.halo = 1.0, "Scenery", True, 5.0
    bpy.ops.fovea.hidden_pen_add()
    bpy.ops.fovea.line_set_add()
    made, below = drawn(scene).line_sets[held.line_set_index :][:2]
    assert below.hidden and below.collection == "Scenery" and below.pen_away is not None
    assert made == below.replace(name="Line Set", collection="", outside=False, hidden=())
    bpy.ops.fovea.line_set_add()
    assert names(scene) == ["outline", "forms", "Line Set.001", "Line Set", "lines"]


def test_a_style_without_line_sets_gets_one_that_draws(scene):
    held = use_style(scene, "technical")
    held.line_sets.clear()
    bpy.ops.fovea.line_set_add()
    (made,) = drawn(scene).line_sets
    assert made.name == "Line Set" and {"contour", "crease"} < set(made.kinds) and made.pen.opacity == 1


def test_hidden_pens_are_added_behind_those_there_are(scene):
    held = use_style(scene, "plain")
    assert not bpy.ops.fovea.hidden_pen_remove.poll()
    bpy.ops.fovea.hidden_pen_add()
    bpy.ops.fovea.hidden_pen_add()
    hidden = drawn(scene).line_sets[-1].hidden
    assert [(h.first, h.last, h.pen.texture) for h in hidden] == [(1, 1, "dashes"), (2, None, "dashes")]
    assert held.line_sets[-1].hidden_index == 1
    bpy.ops.fovea.hidden_pen_remove()
    bpy.ops.fovea.hidden_pen_remove()
    assert drawn(scene).line_sets[-1].hidden == ()


def test_every_operator_tells_what_it_does():
    for module in ("style_operators", "line_set_operators"):
        for cls in registration.classes_of(part(f"style.{module}")):
            assert len(cls.__doc__.split()) > 4 and cls.bl_idname.startswith("fovea.")
            called = getattr(bpy.ops.fovea, cls.bl_idname.partition(".")[2])
            for prop in called.get_rna_type().properties:
                assert prop.identifier == "rna_type" or prop.description or prop.is_hidden, (cls, prop.identifier)


def test_a_saved_style_is_json_that_anyone_can_read(scene):
    use_style(scene, "pencil")
    bpy.ops.fovea.style_save(name="plain words")
    data = json.loads((files.user_folder() / "plain_words.json").read_text())
    assert data["line_sets"][0]["pen"]["width"] == 4.2 and data["schema"] == style.SCHEMA


def animated(scene):
    """technical, with line sets as wide as their number, keyed, and halos of three times that, driven."""
    held = use_style(scene, "technical")
    for i, line_set in enumerate(held.line_sets):
        line_set.pen.width = i + 1
        line_set.pen.keyframe_insert("width", frame=1)
        line_set.driver_add("halo").driver.expression = str(3 * (i + 1))
    return held


def numbers(scene):
    """{name: (width, halo)} that the keys and drivers say."""
    held = own_style(scene)
    for line_set in held.line_sets:
        line_set.pen.width, line_set.halo = 99, 99
    scene.frame_set(2)
    return {line_set.name: (line_set.pen.width, line_set.halo) for line_set in held.line_sets}


def test_what_is_keyed_and_driven_follows_its_line_set(scene):
    held = animated(scene)
    assert numbers(scene) == {"outline": (1, 3), "marks": (2, 6), "lines": (3, 9)}
    held.line_set_index = 0
    bpy.ops.fovea.line_set_move(direction="DOWN")
    assert names(scene) == ["marks", "outline", "lines"]
    assert numbers(scene) == {"outline": (1, 3), "marks": (2, 6), "lines": (3, 9)}
    bpy.ops.fovea.line_set_remove()
    assert numbers(scene) == {"marks": (2, 6), "lines": (3, 9)}
    held.line_set_index = 0
    bpy.ops.fovea.line_set_duplicate()
    assert numbers(scene) == {"marks": (2, 6), "marks.001": (99, 99), "lines": (3, 9)}
    held.line_set_index = 0
    bpy.ops.fovea.line_set_add()
    assert names(scene) == ["Line Set", "marks", "marks.001", "lines"]
    assert numbers(scene) == {"Line Set": (99, 99), "marks": (2, 6), "marks.001": (99, 99), "lines": (3, 9)}


def test_a_copy_of_a_style_is_animated_by_itself(scene):
    animated(scene)
    first = scene.fovea.style
    bpy.ops.fovea.style_duplicate()
    copy = scene.fovea.style
    assert copy != first and copy.animation_data.action != first.animation_data.action
    own_style(scene).line_sets[0].pen.width = 20
    own_style(scene).line_sets[0].pen.keyframe_insert("width", frame=1)
    assert numbers(scene)["outline"] == (20, 3)
    scene.fovea.style = first
    assert numbers(scene)["outline"] == (1, 3)
