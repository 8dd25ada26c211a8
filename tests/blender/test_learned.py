# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines learned from drawings of a scene, in Blender."""

import json
import subprocess
from pathlib import Path

import bpy
import numpy as np
import pytest
from the_addon import part

Laid = part("registered_drawing").Laid
fitted_style, learned_lines, native, style = (
    part(name) for name in ("fitted_style", "learned_lines", "native", "style")
)
problem, style_fit, local_properties = part("scene.problem"), part("render.style_fit"), part("render.local_properties")
whole_pictures = part("render.whole_pictures")
as_rendered, definition_strengths = part("render.as_rendered"), part("render.definition_strengths")
SIZE = 640, 480
SCRIPTS = Path(__file__).parents[2] / "blender_scripts"
ARTIST = {"contour": 1.0, "ridge": 0.3, "valley": 0.3}


@pytest.fixture
def monkey():
    """A smooth monkey before a camera."""
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.mesh.primitive_monkey_add()
    bpy.ops.object.shade_smooth()
    bpy.context.object.modifiers.new("Subdivision", "SUBSURF").render_levels = 2
    scene = bpy.context.scene
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location, camera.rotation_euler = (1.2, -5, 0.6), (np.radians(84), 0, np.radians(14))
    scene.collection.objects.link(camera)
    scene.camera, scene.render.engine = camera, "FOVEA"
    return scene


def drawing(thresholds=ARTIST):
    """The Bitmap of what the style plain draws of definitions with thresholds."""
    wanted = fitted_style.style_with(style.load("plain"), thresholds)

    def take(engine, depsgraph):
        return native.load().Bitmap.of_lines(*style_fit.drawer(engine, depsgraph, wanted)(wanted), *SIZE)

    return as_rendered.look(bpy.context, take, definition_strengths.prepared(SIZE))


def test_what_is_learned_from_a_drawing_draws_the_scene_much_like_it_and_from_elsewhere_too(monkey):
    judge = drawing()
    properties, judges, outlines = local_properties.with_judges(bpy.context, SIZE, None, lambda _: [Laid(judge)])
    assert judges == [judge] and properties.known.shape == SIZE[::-1]
    learned = learned_lines.learn(properties, judges, "forest", outlines=outlines)
    assert learned.found["auc"] > 0.9 and learned.found["f1"] > 0.8, learned.found
    monkey.camera.location, monkey.camera.rotation_euler = (-2.4, -4.4, 0.4), (np.radians(86), 0, np.radians(-29))
    other = local_properties.of_render(bpy.context, SIZE)
    _, lines = learned_lines.drawn(learned.model, other)
    near = lines.measures(drawing(), judge.usual_tolerance)
    assert near["f1"] > 0.75 > judge.measures(drawing(), judge.usual_tolerance)["f1"], near


def test_scans_are_registered_over_the_outlines_of_the_scene(monkey):
    asked = []

    def judges_of(reference):
        asked.append(reference())
        return [Laid(asked[0])]

    *_, found = local_properties.with_judges(bpy.context, SIZE, None, judges_of)
    assert found is asked[0]
    outlines = drawing(dict.fromkeys(fitted_style.outlines_of(style.load("plain")), 1.0))
    assert asked[0].measures(outlines, 0.0)["f1"] == 1.0


def test_properties_are_those_of_a_scene_in_view_of_any_object(monkey):
    away = bpy.data.objects.new("Away", bpy.data.cameras.new("Away"))
    away.location = 0, 0, 50  # looks down
    monkey.collection.objects.link(away)
    bpy.context.view_layer.update()
    found = local_properties.of_render(bpy.context, SIZE, away)
    assert 0 < found.known.mean() < 0.02
    near = local_properties.of_render(bpy.context, SIZE)
    assert near.known.mean() > 0.1


def test_a_scene_without_surfaces_is_refused_in_a_sentence(monkey):
    for obj in [obj for obj in monkey.objects if obj.type == "MESH"]:
        bpy.data.objects.remove(obj)
    with pytest.raises(problem.CannotDraw, match="nothing that has lines"):
        local_properties.of_render(bpy.context, SIZE)


def test_the_command_learns_from_drawings_and_draws_another_scene_by_that(tmp_path):
    drawn, model, told = tmp_path / "drawn.png", tmp_path / "model.json", tmp_path / "told.json"
    small = ["--size", "320x240"]
    script("draw.py", "suzanne:2", "--style", "plain", *small, "-o", drawn)
    script("learn.py", told, "suzanne:2", drawn, "-o", model, "--json")
    assert json.loads(told.read_text())["f1"] > 0.5
    script("learn.py", told, "boxes:3", "--predict", "--model", model, *small, "-o", tmp_path / "by_it.png")
    assert json.loads(told.read_text())["pixels"] > 0 and whole_pictures.is_whole(tmp_path / "by_it.png")


def test_the_command_fits_a_style_to_a_drawing(tmp_path):
    drawn, made, told = tmp_path / "drawn.png", tmp_path / "style.json", tmp_path / "told.json"
    script("draw.py", "boxes:3", "--style", "plain", "--size", "320x240", "-o", drawn)
    script("fit.py", told, "boxes:3", drawn, "-o", made, "--lines", "contour,crease", "--json")
    assert json.loads(told.read_text())["f1"] > 0.8 and json.loads(made.read_text())


def script(name, *words):
    """Runs one of the scripts behind the commands in another Blender with the add-on."""
    where = [bpy.app.binary_path, "-b", "--python-exit-code", "1", "-P", SCRIPTS / name, "--"]
    done = subprocess.run([*where, *map(str, words)], capture_output=True, text=True, errors="replace", timeout=300)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
