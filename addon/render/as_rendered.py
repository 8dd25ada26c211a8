# SPDX-License-Identifier: GPL-3.0-or-later
"""What a final render sees, for operators.

Only a render has a depsgraph with what is made for renders: levels of subdivision, visibility, particles. So Blender's
render is run for one view layer of a copy of the scene, of the same objects, with Fovea as the engine, which hands the
depsgraph over and draws nothing. Handlers of renders are called, as Blender does; compositing and sequencing are left
out. What has been rendered before is kept, as each scene has a result of its own.
"""

from concurrent.futures import Future
from contextlib import contextmanager

import bpy

from ..scene.problem import CannotDraw

_look = None  # what the render that is under way is for: the Future of its result, `take`, the name of the view layer


def looked(engine, depsgraph):
    """Whether a render is not for a picture; then what it is for has been done."""
    if _look is None:
        return False
    outcome, take, layer = _look
    # Without a window Blender renders all view layers; and of a stereo pair the other eye comes, too.
    if depsgraph.view_layer.name == layer and not outcome.done():
        try:
            outcome.set_result(take(engine, depsgraph))
        except Exception as error:  # raised again where the render was asked for
            outcome.set_exception(error)
    return True


def look(context, take):
    """take(engine, depsgraph), called where a render of the context's view layer would be drawn, at the current frame.
    The scene must have a camera. CannotDraw where Blender does not render."""
    global _look
    layer, outcome = context.view_layer, Future()
    with _copy(context.scene) as scene:
        scene.view_layers[layer.name].use = True
        _look = outcome, take, layer.name
        try:
            bpy.ops.render.render(scene=scene.name, layer=layer.name)
        except RuntimeError as error:  # Blender's own words
            raise CannotDraw(str(error).removeprefix("Error: ").strip()) from error
        finally:
            _look = None
    if not outcome.done():
        raise CannotDraw("Blender is rendering: try again when it is done")
    return outcome.result()


@contextmanager
def _copy(scene):
    """A scene of the same objects, for a while."""
    made = scene.copy()
    render = made.render
    render.engine, render.use_freestyle = "FOVEA", False
    render.use_compositing = render.use_sequencer = False
    try:
        yield made
    finally:
        bpy.data.scenes.remove(made)
