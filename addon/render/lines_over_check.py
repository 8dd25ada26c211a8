# SPDX-License-Identifier: GPL-3.0-or-later
"""What keeps lines from a scene's renders is told when a render begins; scenes that draw lines are kept in step with
those they follow as these are changed. Handlers of renders run beside Blender's interface and change no data there."""

import bpy
from bpy.app.handlers import persistent

from . import compositor, lines_over, lines_scenes

REPAIR = "press Repair in the panel Fovea Lines"


def problems(scene):
    """Yields a sentence for each thing that keeps lines from a scene's renders; none if it shall have none."""
    drawn = lines_over.places(scene)
    if lines_scenes.strays(scene):
        yield f"a view layer that had lines is gone; {REPAIR}"
    for layer in drawn:
        yield from _problems_of(scene, layer)
    if drawn and not scene.render.use_compositing:
        yield f"Compositing is off in the output properties; {REPAIR}"
    if drawn and scene.render.use_single_layer:
        yield f"Render Single Layer is on, and Blender composites nothing then; {REPAIR}"
    if drawn and _has_strips(scene) and scene.render.use_sequencer:
        yield "the sequencer has strips, which are rendered in place of the picture; turn off Sequencer in the output"


def _problems_of(scene, layer):
    """Those of what lays lines over the whole picture (None) or over that of a view layer."""
    over, shown = (lines_over.node(scene, mark, layer) for mark in (lines_over.OVER, lines_over.LINES))
    lines = lines_scenes.of(scene, layer)
    if over is None or shown is None or lines is None:
        yield f"nodes of the compositor, or the scene that draws the lines, are missing; {REPAIR}"
        return
    if over.mute or shown.mute or shown.scene != lines or not _is_linked(over, shown):
        yield f"nodes of the compositor are muted, not linked, or show another scene; {REPAIR}"
    out = compositor.output(compositor.tree(scene))
    if layer is None and (out is None or not out.is_linked):
        yield f"the compositor has no output; {REPAIR}"


def _is_linked(over, layer):
    source = over.inputs["Lines"].links[0] if over.inputs["Lines"].is_linked else None
    shown = source and source.from_node == layer and source.from_socket.name == "Lines"
    return shown and over.inputs["Image"].is_linked and over.outputs[0].is_linked


def _has_strips(scene):
    editor = scene.sequence_editor
    strips = getattr(editor, "strips", None) or getattr(editor, "sequences", ())
    return any(strip.type != "SOUND" for strip in strips)


@persistent
def _tell(scene, *_):
    """A render begins."""
    for lines in lines_scenes.all_of(scene) if bpy.app.background else ():  # the render is in Blender's main thread
        lines_scenes.follow(lines)
    for sentence in problems(scene):
        _print(scene, sentence)


@persistent
def _tell_failure(scene, *_):
    """A frame is rendered."""
    if sentence := lines_scenes.failure(scene):
        _print(scene, sentence)


def _print(scene, sentence):
    print(f"\033[31mFovea draws no lines over '{scene.name}': {sentence}\033[0m", flush=True)


@persistent
def _follow(*_):
    for lines in bpy.data.scenes:
        if lines.fovea.lines_of and lines.library is None:
            lines_scenes.follow(lines)


HANDLERS = {"render_init": _tell, "render_post": _tell_failure, "load_post": _follow, "depsgraph_update_post": _follow}


def register():
    for name, function in HANDLERS.items():
        getattr(bpy.app.handlers, name).append(function)


def unregister():
    for name, function in HANDLERS.items():
        getattr(bpy.app.handlers, name).remove(function)
