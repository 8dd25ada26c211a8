# SPDX-License-Identifier: GPL-3.0-or-later
"""What a Blender before 4.3 has not, its users are told in a sentence. This one is made to believe that it is older."""

import bpy
import pytest
from pictures import box_scene
from the_addon import part, use_style


@pytest.fixture
def scene(monkeypatch):
    monkeypatch.setattr(part("scene.pencils"), "are_there", lambda: False)
    scene = box_scene()
    use_style(scene, "plain")
    return scene


def test_baking_as_grease_pencil_says_what_to_do_instead(scene):
    with pytest.raises(RuntimeError, match="from Blender 4.3 on: bake with the type Mesh"):
        bpy.ops.fovea.bake_strokes(kind="GREASE_PENCIL")
    assert "Lines" not in bpy.data.collections


def test_baked_as_meshes_it_says_why(scene, capfd):
    assert bpy.ops.fovea.bake_strokes(kind="MESH") == {"FINISHED"}
    assert bpy.data.collections["Lines"].objects[0].type == "MESH"
    assert "as meshes: strokes of Grease Pencil need Blender 4.3 or later" in capfd.readouterr().out


def test_line_art_is_not_matched_and_it_says_why(scene):
    with pytest.raises(RuntimeError, match="Line Art can be matched in Blender 4.3 and later"):
        bpy.ops.fovea.match_line_art()
    assert not list(part("style.line_art").modifiers_of(scene))
