# SPDX-License-Identifier: GPL-3.0-or-later
"""Styles as assets: marked with a thumbnail, cleared, and used from another file."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from the_addon import empty_scene, lines_of, part, use_style

assets, native, pictures = part("style.style_assets"), part("native"), part("style.style_picture")
style, style_data, style_read = part("style"), part("style.style_data"), part("style.style_read")


@pytest.fixture
def scene():
    made = empty_scene()
    use_style(made, "charcoal")
    return made


def shown(tree):
    """(H, W, 3) of its preview."""
    width, height = tree.preview.image_size
    pixels = np.empty(4 * width * height, np.float32)
    tree.preview.image_pixels_float.foreach_get(pixels)
    return np.round(255 * pixels.reshape(height, width, 4)[..., :3]).astype(np.uint8)


def test_a_marked_style_has_its_thumbnail_and_words(scene):
    tree = scene.fovea.style
    assert bpy.ops.fovea.style_mark_asset(description="Soft", author="Me", tags="soft, , dark,soft") == {"FINISHED"}
    told = tree.asset_data
    assert (told.description, told.author) == ("Soft", "Me")
    assert sorted(tag.name for tag in told.tags) == ["Fovea", "dark", "soft"]
    assert np.array_equal(shown(tree), pictures.draw(style_read.read(tree)))
    lines_of(scene).pen.width = 20
    bpy.ops.fovea.style_mark_asset(tags="wide")
    assert np.array_equal(shown(tree), pictures.draw(style_read.read(tree))), "marked again, it shows what it is now"
    assert sorted(tag.name for tag in tree.asset_data.tags) == ["Fovea", "wide"]


def test_marking_is_undone_and_redone(scene):
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.fovea.style_mark_asset(description="Soft")
    bpy.ops.ed.undo_push(message="after")
    bpy.ops.ed.undo()
    assert bpy.context.scene.fovea.style.asset_data is None
    bpy.ops.ed.redo()
    tree = bpy.context.scene.fovea.style
    assert tree.asset_data.description == "Soft"
    assert np.array_equal(shown(tree), pictures.draw(style_read.read(tree)))


def test_clearing_leaves_the_style(scene):
    assert not bpy.ops.fovea.style_clear_asset.poll()
    bpy.ops.fovea.style_mark_asset()
    before = style_read.read(scene.fovea.style)
    assert bpy.ops.fovea.style_clear_asset() == {"FINISHED"}
    assert scene.fovea.style.asset_data is None and style_read.read(scene.fovea.style) == before
    assert not bpy.ops.fovea.style_clear_asset.poll()


def test_an_asset_is_no_spare_style(scene):
    bpy.ops.fovea.style_mark_asset()
    marked = scene.fovea.style
    bpy.ops.fovea.style_apply(style="pencil")
    assert marked in set(bpy.data.node_groups)


def test_without_a_native_module_there_is_no_thumbnail(scene, monkeypatch):
    monkeypatch.setattr(native, "problem", lambda: "not there")
    monkeypatch.setattr(pictures, "draw", lambda *_: pytest.fail("drawn all the same"))
    assert bpy.ops.fovea.style_mark_asset() == {"FINISHED"}
    assert scene.fovea.style.asset_data[assets.MARK] == 1


@pytest.fixture
def library(scene, tmp_path):
    """The .blend file of a marked style, and what the style is."""
    lines_of(scene).pen.width = 17.5
    bpy.ops.fovea.style_mark_asset(tags="wide")
    scene.fovea.style.name = "Wide"
    path, chosen = tmp_path / "library" / "styles.blend", style_read.read(scene.fovea.style)
    path.parent.mkdir()
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    empty_scene()
    return path, chosen


def use(path, **how):
    bpy.ops.fovea.style_use_asset(filepath=str(path), name="Wide", **how)
    return bpy.context.scene.fovea.style


@pytest.mark.parametrize("method", ["LINK", "APPEND", "APPEND_REUSE", "PACK"])
def test_a_style_of_another_file_is_brought_as_wanted(library, method):
    path, chosen = library
    tree = use(path, method=method)
    assert style_read.read(tree) == chosen
    assert (tree.library is not None) == (method in ("LINK", "PACK"))
    assert method in ("LINK", "PACK") or tree.asset_data is None, "a copy is no other asset"
    assert bpy.ops.fovea.style_mark_asset.poll() == (tree.library is None)
    bpy.context.scene.fovea.style = None
    again = use(path, method=method)
    assert (again == tree) == (method != "APPEND")


def test_the_librarys_import_method_holds_where_none_is_said(library):
    path, _ = library
    libraries = bpy.context.preferences.filepaths.asset_libraries
    added = libraries.new(name="Ours", directory=str(path.parent))
    try:
        for method, linked in (("LINK", True), ("APPEND", False)):
            added.import_method = method
            assert assets.method_of(str(path)) == method
            assert (use(path).library is not None) == linked
        pressed = {"asset_library_type": "CUSTOM", "relative_asset_identifier": "styles.blend/NodeTree/Wide"}
        bpy.context.scene.fovea.style = None
        bpy.ops.fovea.style_use_asset(asset_library_identifier="Ours", **pressed)
        assert bpy.context.scene.fovea.style.name.startswith("Wide")
        with pytest.raises(RuntimeError, match="no asset library 'Others'"):
            bpy.ops.fovea.style_use_asset(asset_library_identifier="Others", **pressed)
    finally:
        libraries.remove(added)
    assert assets.method_of(str(path)) == "APPEND"


def test_an_asset_of_this_file_is_used_itself(scene):
    bpy.ops.fovea.style_mark_asset()
    tree = scene.fovea.style
    bpy.ops.fovea.style_apply(style="pencil")
    bpy.ops.fovea.style_use_asset(asset_library_type="LOCAL", relative_asset_identifier=f"NodeTree/{tree.name}")
    assert scene.fovea.style == tree


def test_what_is_no_style_is_refused_in_a_sentence(scene, library):
    path, _ = library
    with pytest.raises(RuntimeError, match="Choose a Fovea style"):
        bpy.ops.fovea.style_use_asset()
    for file, name in ((path, "None such"), ("", "None such"), (path.with_name("gone.blend"), "Wide")):
        with pytest.raises(RuntimeError) as refused:
            bpy.ops.fovea.style_use_asset(filepath=str(file), name=name)
        assert "Traceback" not in str(refused.value)


def test_the_browser_and_the_shelf_know_styles_from_other_assets(scene):
    bpy.ops.fovea.style_mark_asset()
    found = SimpleNamespace(id_type="NODETREE", metadata=scene.fovea.style.asset_data)
    other = bpy.data.node_groups.new("Other", "ShaderNodeTree")
    other.asset_mark()
    assert assets.is_style_asset(found) and assets.VIEW3D_AST_fovea_styles.asset_poll(found)
    assert not assets.is_style_asset(SimpleNamespace(id_type="NODETREE", metadata=other.asset_data))
    assert not assets.is_style_asset(None)
