# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes that draw the lines of another scene (scene/followed.py): made, found, and kept in step with it.

Those of the lines of one view layer have the other scene's collections and objects, and what the layer says of them:
a background set has always the first view layer that is rendered."""

import bpy

ENGINE = "FOVEA"
# Settings that Blender itself reads of the scene that it renders.
OF_RENDER = (
    *("use_border", "use_crop_to_border", "pixel_aspect_x", "pixel_aspect_y", "frame_map_old", "frame_map_new"),
    *("use_simplify", "simplify_subdivision_render", "simplify_child_particles_render", "hair_type", "hair_subdiv"),
    *("use_multiview", "views_format"),
)
OF_LAYER = "exclude", "holdout", "indirect_only"  # settings of collections in a view layer; the first sets all below
FIXED = {"engine": ENGINE, "film_transparent": True, "use_freestyle": False, "use_sequencer": False}


_failures = {}  # name of a scene that draws lines -> why its last render did not


def note(lines, sentence):
    """Notes why a scene that draws lines did not; None: it is about to."""
    _failures[lines.name] = sentence


def failure(scene):
    """Why lines do not lie over a scene's last render, or None. Blender itself tells nobody: the picture is
    rendered."""
    return next(filter(None, (_failures.get(lines.name) for lines in all_of(scene))), None)


def all_of(scene):
    """All scenes that draw lines of a scene."""
    return [other for other in bpy.data.scenes if other.fovea.lines_of == scene and other.library is None]


def of(scene, layer=None):
    """The scene that draws a scene's lines, or those of one of its view layers alone; or None."""
    return next((lines for lines in all_of(scene) if _is_of(lines, layer)), None)


def _is_of(lines, layer):
    return layer_of(lines) == layer and lines.fovea.lines_of_layer == (layer is not None)


def layer_of(lines):
    """The view layer whose lines alone a scene draws, or None."""
    return next((layer for layer in lines.fovea.lines_of.view_layers if layer.fovea.lines == lines), None)


def strays(scene):
    """Scenes that draw the lines of view layers that a scene has no longer."""
    return [lines for lines in all_of(scene) if lines.fovea.lines_of_layer and layer_of(lines) is None]


def make(scene, layer=None):
    """A new scene that draws a scene's lines, or those of one of its view layers alone, in step with it."""
    made = bpy.data.scenes.new(f"{scene.name} {layer.name} Lines" if layer else f"{scene.name} Lines")
    made.fovea.lines_of, made.fovea.lines_of_layer = scene, layer is not None
    made.view_layers[0].name = "Lines"
    if layer:
        layer.fovea.lines = made
    made.eevee.taa_render_samples = 1  # Blender renders scenes whose engine is missing by EEVEE
    follow(made)
    return made


def out_of_step(lines):
    """What Blender would read otherwise of a scene that draws lines than of the one it follows: {(owner, name of a
    property): the value it should have}."""
    scene = lines.fovea.lines_of
    wanted = {(lines.render, name): getattr(scene.render, name) for name in OF_RENDER}
    wanted |= {(lines.render, name): value for name, value in FIXED.items()}
    background = None if lines.fovea.lines_of_layer else scene
    wanted |= {(lines, "background_set"): background, (lines.view_layers[0], "use"): True}
    wanted |= {} if lines.camera else {(lines, "camera"): scene.camera}  # Blender asks for any
    return {place: value for place, value in wanted.items() if getattr(*place) != value}


def follow(lines):
    """Brings a scene that draws lines in step with the one it follows."""
    for (owner, name), value in out_of_step(lines).items():
        setattr(owner, name, value)
    if layer := layer_of(lines):
        _share(lines.collection, lines.fovea.lines_of.collection)
        _agree(_collections(lines.view_layers[0]), _collections(layer))


def _share(own, others):
    """Gives a collection the collections and objects of another one."""
    for kind in ("children", "objects"):
        mine, wanted = getattr(own, kind), getattr(others, kind)
        had, wants = set(mine), set(wanted)
        for each in had - wants:
            mine.unlink(each)
        for each in wanted if wants - had else ():
            if each not in had:
                mine.link(each)


def _collections(layer):
    """What a view layer says of its scene's collections, as these are now."""
    _ = layer.objects.active  # makes Blender look at them
    return layer.layer_collection


def _agree(own, other):
    """Sets what a view layer says of its collections as another one does."""
    for child in other.children:
        mine = own.children.get(child.name)
        for name in OF_LAYER if mine else ():
            if getattr(mine, name) != getattr(child, name):
                setattr(mine, name, getattr(child, name))
        if mine:
            _agree(mine, child)
