# SPDX-License-Identifier: GPL-3.0-or-later
"""The gallery of styles, and where it stands in the render tab."""

import bpy
import pytest
from the_addon import empty_scene, part, use_style

style, files = part("style"), part("style.style_files")


@pytest.fixture
def scene(tmp_path, monkeypatch):
    """The user's styles are in a folder of the test."""
    monkeypatch.setattr(files, "user_folder", lambda create=False: tmp_path)
    return empty_scene()


@pytest.fixture
def manager():
    return bpy.context.window_manager


def items(manager):
    """{identifier: label} of the pictures."""
    found = part("ui.gallery")._listed(manager, bpy.context)
    return {identifier: label for identifier, label, *_ in found}


def test_it_shows_the_style_that_draws_and_a_choice_applies_another(scene, manager):
    assert manager.fovea_gallery == style.DEFAULT, "a scene without a style of its own"
    manager.fovea_gallery = "charcoal"
    assert (scene.fovea.style.name, manager.fovea_gallery) == ("Charcoal", "charcoal")
    scene.fovea.style.fovea.paper.tint = 0.5
    assert manager.fovea_gallery == "charcoal", "edited, it came from there all the same"


def test_styles_of_the_user_are_in_it_and_one_that_came_from_no_preset(scene, manager):
    assert list(items(manager)) == files.names()
    manager.fovea_gallery = "pencil"
    assert bpy.ops.fovea.style_save(name="Mine") == {"FINISHED"}
    assert items(manager)["mine"] == "Mine" and manager.fovea_gallery == "mine"
    use_style(scene, "plain")
    scene.fovea.style.name = "Imported"
    assert (manager.fovea_gallery, items(manager)["FOVEA_OWN"]) == ("FOVEA_OWN", "Imported")
    manager.fovea_gallery = "FOVEA_OWN"
    assert scene.fovea.style.name == "Imported"


def test_words_of_the_pictures_are_kept_as_long_as_blender_may_show_them(scene, manager):
    gallery = part("ui.gallery")
    assert gallery._listed(manager, bpy.context) is gallery._listed(manager, bpy.context)


def test_simplify_stands_below_the_styles():
    names = [cls.__name__ for cls in bpy.types.Panel.__subclasses__()]  # in the order of registration
    assert names.index("RENDER_PT_fovea_style") < names.index("RENDER_PT_fovea_simplify")
    assert "FOVEA" not in bpy.types.RENDER_PT_simplify.COMPAT_ENGINES
    for part_of in ("", "_viewport", "_render"):
        own, panel = (getattr(bpy.types, f"RENDER_PT_{name}simplify{part_of}") for name in ("fovea_", ""))
        assert own.COMPAT_ENGINES == {"FOVEA"} and own.draw is panel.draw and own.bl_label == panel.bl_label
        assert getattr(own, "bl_parent_id", "") == ("RENDER_PT_fovea_simplify" if part_of else "")
