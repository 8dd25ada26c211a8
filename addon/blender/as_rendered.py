"""What a final render sees, for operators.

Only a render has a depsgraph with what is made for renders: levels of subdivision, visibility, particles. So Blender's
render is run for one view layer with Fovea as the engine, which hands the depsgraph over and draws nothing. Handlers of
renders are called, as Blender does; compositing and sequencing are left out. What has been rendered before is kept: the
empty result goes to a slot that is free.
"""

from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

import bpy
import numpy as np

from .problem import CannotDraw

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
        with _set(scene.render, _PLAIN), _set(layer, {"use": True}), _free_slot(scene):
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
        for name in changed:  # what others depend on comes first, here, too
            setattr(settings, name, before[name])


@contextmanager
def _free_slot(scene):
    """For a while the Render Result, if there is one, shows a slot that holds no picture, the last of these. None is made:
    were it taken away again by undoing what asks for this, Blender would lose what the others hold."""
    image = next((image for image in bpy.data.images if image.type == "RENDER_RESULT"), None)
    if image is None:
        yield
        return
    slots, before = image.render_slots, image.render_slots.active_index
    try:
        others = (i for i in reversed(range(len(slots))) if i != before)
        if next((i for i in others if _is_free(image, i, scene)), None) is None:
            raise CannotDraw("All slots of the Render Result hold pictures: render anew into one that you do not need")
        yield
    finally:
        slots.active_index = before


def _is_free(image, index, scene):
    """Whether a slot, which becomes the active one, holds nothing, or a picture that is black all over, as is left here."""
    image.render_slots.active_index = index
    stored, wanted = scene.render.image_settings, {"file_format": "PNG", "color_mode": "RGB", "color_depth": "8"}
    if hasattr(stored, "media_type"):
        wanted = {"media_type": "IMAGE"} | wanted
    with TemporaryDirectory() as folder, _set(stored, wanted):
        path = str(Path(folder) / "slot.png")
        try:
            image.save_render(path, scene=scene)
        except RuntimeError:  # Blender has nothing to save
            return True
        held = bpy.data.images.load(path)
        pixels = np.empty(len(held.pixels), np.float32)
        held.pixels.foreach_get(pixels)
        bpy.data.images.remove(held)
    return not pixels.reshape(-1, 4)[:, :3].any()
