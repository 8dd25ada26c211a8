# SPDX-License-Identifier: GPL-3.0-or-later
"""Access to the depsgraph of a final render, for operators.

Only a render evaluates a depsgraph with render settings: levels of subdivision, visibility, particles. So Blender
renders one view layer of a linked copy of the scene with Fovea as the engine, which passes the depsgraph to a callback
and draws nothing. Blender calls the render handlers as usual; compositing and sequencing are off. The original scene's
render result stays, because each scene has its own.
"""

from concurrent.futures import Future
from contextlib import contextmanager

import bpy

from ..scene.problem import CannotDraw

_original = None  # name of the scene of whose copy that is
_look = None  # of the render in progress, if `look` started it: (Future of the result, `take`, name of the view layer)


def is_looking():
    """Whether `look` started the render in progress, which writes nothing."""
    return _look is not None


def name_of(scene):
    """Name of a scene; of the copy that `look` renders, that of the original."""
    return _original or scene.name


def looked(engine, depsgraph):
    """Whether `look` started this render, so that nothing is to be drawn; calls its `take` once, for its view layer."""
    if _look is None:
        return False
    outcome, take, layer = _look
    # In background mode Blender renders all view layers, and with stereo once per eye: take only the first match.
    if depsgraph.view_layer.name == layer and not outcome.done():
        try:
            outcome.set_result(take(engine, depsgraph))
        except Exception as error:  # raised again in `look`
            outcome.set_exception(error)
    return True


def look(context, take, prepare=None):
    """Returns take(engine, depsgraph), called from a final render of the context's view layer at the current frame.
    `prepare(scene)` may change the copy of the scene that is rendered. It must have a camera. CannotDraw if Blender
    does not render."""
    global _look, _original
    layer, outcome = context.view_layer, Future()
    with _copy(context.scene) as scene:
        scene.view_layers[layer.name].use = True
        if prepare:
            prepare(scene)
        _look, _original = (outcome, take, layer.name), context.scene.name
        try:
            bpy.ops.render.render(scene=scene.name, layer=layer.name)
        except RuntimeError as error:  # with Blender's message
            raise CannotDraw(str(error).removeprefix("Error: ").strip()) from error
        finally:
            _look = _original = None
    if not outcome.done():
        raise CannotDraw("Blender is rendering: try again when it is done")
    return outcome.result()


def see_from(camera, scene):
    """Makes an object the camera of a scene, which no marker changes. CannotDraw if it is not in the scene."""
    if camera.name not in scene.objects or scene.objects[camera.name] != camera:
        raise CannotDraw(f"'{camera.name}' is not in the scene: add it, or name a camera that is")
    scene.timeline_markers.clear()
    scene.camera = camera


@contextmanager
def _copy(scene):
    """Context with a linked copy of a scene (same objects), set up for `look`; removed afterwards."""
    made = scene.copy()
    render = made.render
    render.engine, render.use_freestyle = "FOVEA", False
    render.use_compositing = render.use_sequencer = False
    try:
        yield made
    finally:
        bpy.data.scenes.remove(made)
