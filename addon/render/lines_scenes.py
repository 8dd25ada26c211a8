# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes that draw the lines of another scene (scene/followed.py): made, found, and kept in step with it."""

import bpy

ENGINE = "FOVEA"
# Settings that Blender itself reads of the scene that it renders.
OF_RENDER = (
    *("use_border", "use_crop_to_border", "pixel_aspect_x", "pixel_aspect_y", "frame_map_old", "frame_map_new"),
    *("use_simplify", "simplify_subdivision_render", "simplify_child_particles_render", "hair_type", "hair_subdiv"),
    *("use_multiview", "views_format"),
)
FIXED = {"engine": ENGINE, "film_transparent": True, "use_freestyle": False, "use_sequencer": False}


_failures = {}  # name of a scene that draws lines -> why its last render did not


def note(lines, sentence):
    """Notes why a scene that draws lines did not; None: it is about to."""
    _failures[lines.name] = sentence


def failure(scene):
    """Why no lines lie over a scene's last render, or None. Blender itself tells nobody: the picture is rendered."""
    lines = of(scene)
    return _failures.get(lines.name) if lines else None


def of(scene):
    """The scene that draws a scene's lines, or None."""
    return next((other for other in bpy.data.scenes if other.fovea.lines_of == scene and other.library is None), None)


def make(scene):
    """A new scene that draws a scene's lines, in step with it."""
    made = bpy.data.scenes.new(f"{scene.name} Lines")
    made.fovea.lines_of = made.background_set = scene
    made.view_layers[0].name = "Lines"
    made.eevee.taa_render_samples = 1  # Blender renders scenes whose engine is missing by EEVEE
    follow(made)
    return made


def out_of_step(lines):
    """What Blender would read otherwise of a scene that draws lines than of the one it follows: {(owner, name of a
    property): the value it should have}."""
    scene = lines.fovea.lines_of
    wanted = {(lines.render, name): getattr(scene.render, name) for name in OF_RENDER}
    wanted |= {(lines.render, name): value for name, value in FIXED.items()}
    wanted |= {(lines, "background_set"): scene, (lines.view_layers[0], "use"): True}
    wanted |= {} if lines.camera else {(lines, "camera"): scene.camera}  # Blender asks for any
    return {place: value for place, value in wanted.items() if getattr(*place) != value}


def follow(lines):
    """Brings a scene that draws lines in step with the one it follows."""
    for (owner, name), value in out_of_step(lines).items():
        setattr(owner, name, value)
