"""What a final render sees, for operators.

Only a render has a depsgraph with what is made for renders: levels of subdivision, visibility, particles. So Blender's
render is run for one view layer with Fovea as the engine, which hands the depsgraph over and draws nothing. Handlers of
renders are called, as Blender does; compositing and sequencing are left out. What has been rendered before is kept: the
empty result has a slot of its own.
"""

from contextlib import contextmanager

import bpy

from .problem import CannotDraw

SLOT = "Fovea"  # of the Render Result
_PLAIN = {"engine": "FOVEA", "use_compositing": False, "use_sequencer": False, "use_freestyle": False}

_look = None  # what the render that is under way is for


class _Look:
    """One use of a render."""

    def __init__(self, take, layer):
        self.take, self.layer = take, layer
        self.taken, self.result, self.error = False, None, None

    def run(self, engine, depsgraph):
        # Without a window Blender renders all view layers; and of a stereo pair the other eye comes, too.
        if self.taken or depsgraph.view_layer.name != self.layer:
            return
        self.taken = True
        try:
            self.result = self.take(engine, depsgraph)
        except Exception as error:  # raised again where the render was asked for
            self.error = error


def looked(engine, depsgraph):
    """Whether a render is not for a picture; then what it is for has been done."""
    if _look:
        _look.run(engine, depsgraph)
    return _look is not None


def look(context, take):
    """take(engine, depsgraph), called where a render of the context's view layer would be drawn, at the current frame.
    The scene must have a camera. CannotDraw where Blender does not render."""
    global _look
    scene, layer = context.scene, context.view_layer
    done = _look = _Look(take, layer.name)
    try:
        with _set(scene.render, _PLAIN), _set(layer, {"use": True}), _own_slot():
            bpy.ops.render.render(scene=scene.name, layer=layer.name)
    except RuntimeError as error:  # Blender's own words
        raise CannotDraw(str(error).removeprefix("Error: ").strip()) from error
    finally:
        _look = None
    if done.error:
        raise done.error
    if not done.taken:
        raise CannotDraw("Blender is rendering: try again when it is done")
    return done.result


@contextmanager
def _set(settings, wanted):
    """Settings that have other values for a while."""
    before = {name: getattr(settings, name) for name in wanted}
    changed = [name for name, value in wanted.items() if before[name] != value]
    try:
        for name in changed:
            setattr(settings, name, wanted[name])
        yield
    finally:
        for name in reversed(changed):
            setattr(settings, name, before[name])


@contextmanager
def _own_slot():
    """The Render Result, if there is one, in a slot of its own for a while."""
    image = next((image for image in bpy.data.images if image.type == "RENDER_RESULT"), None)
    if image is None:
        yield
        return
    slots, before = image.render_slots, image.render_slots.active_index
    found = next((i for i, slot in enumerate(slots) if slot.name == SLOT), None)
    if found is None:
        slots.new(name=SLOT)
        found = len(slots) - 1
        # Were the slot taken away by undoing what asks for this, Blender would lose the memory of its result.
        if not bpy.app.background:
            bpy.ops.ed.undo_push(message="Render Slot for Fovea")
    try:
        slots.active_index = found
        yield
    finally:
        slots.active_index = before
