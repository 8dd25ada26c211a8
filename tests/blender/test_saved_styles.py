# SPDX-License-Identifier: GPL-3.0-or-later
"""The user's saved styles: thumbnails, update, rename, and the preferred default."""

import os
import struct

import bpy
import numpy as np
import pytest
from pictures import pixels_of
from the_addon import empty_scene, lines_of, part, use_style

files, native, pictures = part("style.style_files"), part("native"), part("style.style_picture")
preferences, style, thumbnails = part("ui.preferences"), part("style"), part("ui.thumbnails")
style_data, properties = part("style.style_data"), part("render.properties")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Where the user's styles are."""
    made = tmp_path / "styles"
    made.mkdir()
    monkeypatch.setattr(files, "user_folder", lambda create=False: made)
    empty_scene()
    return made


@pytest.fixture
def scene(folder):
    use_style(bpy.context.scene, "pencil")
    return bpy.context.scene


def inside(folder):
    return sorted(path.name for path in folder.parent.rglob("*") if path.is_file())


@pytest.mark.parametrize("name", style.names())
def test_a_thumbnail_shows_what_the_style_does(name):
    drawn = pictures.draw(style.load(name)).astype(float)
    assert drawn.shape == (pictures.SIZE, pictures.SIZE, 3)
    paper = np.median(drawn[-20:, :20].reshape(-1, 3), axis=0)
    inked = np.abs(drawn - paper).max(axis=2) > 24
    assert inked[64:192, 64:192].mean() > 0.01, "there is hardly a line"
    assert np.array_equal(drawn, pictures.draw(style.load(name))), "the same every time"


def test_a_thumbnail_is_drawn_beside_the_scene(scene):
    before = {name: len(getattr(bpy.data, name)) for name in ("images", "meshes", "scenes", "objects", "node_groups")}
    bpy.ops.fovea.style_save(name="own")
    assert before == {name: len(getattr(bpy.data, name)) for name in before}


def test_a_png_of_a_thumbnail_is_the_thumbnail(tmp_path):
    drawn = pictures.draw(style.load("watercolor"))
    (tmp_path / "a.png").write_bytes(pictures.png(drawn))
    read = np.round(255 * pixels_of(tmp_path / "a.png")[..., :3])
    assert np.array_equal(read, drawn)


def test_the_picture_goes_with_its_style(scene, folder):
    bpy.ops.fovea.style_save(name="own")
    assert inside(folder) == ["own.json", "own.png"] and files.picture("own") == folder / "own.png"
    first = files.picture("own").read_bytes()
    lines_of(scene).pen.width = 12
    bpy.ops.fovea.style_update()
    assert files.picture("own").read_bytes() != first
    assert files.load("own").line_sets[-1].pen.width == 12
    bpy.ops.fovea.style_rename(style="own", name="Other One")
    assert inside(folder) == ["other_one.json", "other_one.png"]
    lines_of(scene).pen.width = 13
    bpy.ops.fovea.style_update()
    assert files.load("other_one").line_sets[-1].pen.width == 13, "the style knows its new name"
    bpy.ops.fovea.style_delete(style="other_one")
    assert inside(folder) == []


def test_a_name_that_is_taken_is_refused_and_nothing_is_lost(scene, folder):
    for name in ("one", "two"):
        bpy.ops.fovea.style_save(name=name)
    for name, why in (("Two", "already"), ("Pencil", "ships"), ("../..", "letters")):
        with pytest.raises(RuntimeError, match=why):
            bpy.ops.fovea.style_rename(style="one", name=name)
    assert inside(folder) == ["one.json", "one.png", "two.json", "two.png"]


def test_only_a_style_that_was_saved_is_updated(scene, folder):
    assert not bpy.ops.fovea.style_update.poll() and not bpy.ops.fovea.style_rename.poll()
    bpy.ops.fovea.style_save(name="own")
    bpy.ops.fovea.style_apply(style="charcoal")
    assert not bpy.ops.fovea.style_update.poll()
    bpy.ops.fovea.style_apply(style="own")
    assert bpy.ops.fovea.style_update.poll()
    bpy.ops.fovea.style_duplicate()
    assert bpy.ops.fovea.style_update.poll()
    (folder / "own.json").unlink()
    assert not bpy.ops.fovea.style_update.poll()


def test_a_missing_or_broken_picture_does_no_harm(scene, folder):
    bpy.ops.fovea.style_save(name="own")
    assert thumbnails.icon_of("own") >= 0
    (folder / "own.png").write_bytes(b"no picture")
    assert thumbnails.icon_of("own") >= 0
    (folder / "own.png").unlink()
    assert files.picture("own") is None and thumbnails.icon_of("own") > 0
    bpy.ops.fovea.style_rename(style="own", name="other")
    bpy.ops.fovea.style_delete(style="other")
    thumbnails.forget()


def test_no_picture_is_taken_from_outside_the_folder(scene, folder, tmp_path):
    bpy.ops.fovea.style_save(name="own")
    (folder / "own.png").replace(tmp_path / "far.png")
    assert files.picture("../far") is None
    (folder / "own.png").symlink_to(tmp_path / "far.png")
    assert files.picture("own") is None
    before = (tmp_path / "far.png").read_bytes()
    lines_of(scene).pen.width = 14
    bpy.ops.fovea.style_update()
    assert (tmp_path / "far.png").read_bytes() == before and files.picture("own") == folder / "own.png"


def test_a_picture_that_is_huge_or_a_pipe_is_not_loaded(scene, folder):
    bpy.ops.fovea.style_save(name="own")
    path = folder / "own.png"
    data = path.read_bytes()
    for side, shown in ((files.LARGEST, path), (files.LARGEST + 1, None), (30000, None)):
        path.write_bytes(data[:16] + struct.pack(">II", side, 1) + data[24:])
        assert files.picture("own") == shown
    path.unlink()
    os.mkfifo(path)
    assert files.picture("own") is None


def test_what_a_killed_blender_left_of_a_style_is_none(scene, folder):
    bpy.ops.fovea.style_save(name="own")
    (folder / ".0123.json").write_bytes((folder / "own.json").read_bytes())
    assert files.user_names() == ["own"]


def test_without_a_native_module_a_style_is_saved_without_a_picture(scene, folder, monkeypatch):
    bpy.ops.fovea.style_save(name="own")

    def missing(*_):
        raise native.Unavailable("not there")

    monkeypatch.setattr(pictures, "draw", missing)
    assert bpy.ops.fovea.style_update() == {"FINISHED"}
    assert inside(folder) == ["own.json"]


def test_the_preferred_style_is_what_new_gives_and_comes_first(scene, folder, monkeypatch):
    bpy.ops.fovea.style_save(name="own")

    class Wanted:
        default_style = "own"

    scene.fovea.style = None
    plain = properties.style_of(scene)
    monkeypatch.setattr(files, "own", Wanted)
    assert files.names()[0] == "own" and sorted(files.names()) == sorted({*style.names(), "own"})
    assert properties.style_of(scene) == plain == style.load(style.DEFAULT), "who has no style draws as everywhere"
    bpy.ops.fovea.style_new()
    assert scene.fovea.style.fovea.source == "own" and bpy.ops.fovea.style_update.poll()
    Wanted.default_style = "gone"
    assert files.names()[0] == style.DEFAULT


def test_preferences_name_the_default_style():
    entry = bpy.types.AddonPreferences.bl_rna_get_subclass_py("FoveaPreferences") or preferences.FoveaPreferences
    told = entry.bl_rna.properties["default_style"]
    assert told.default == style.DEFAULT and "every machine" in told.description
