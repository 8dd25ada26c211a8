# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that output the lines of a final render: as an image with alpha, or as objects."""

from contextlib import contextmanager
from functools import partial

import bpy
import numpy as np

from .. import native, pipeline
from ..scene import camera, followed, pencils
from ..scene.operator import Operator
from ..scene.problem import CannotDraw
from . import as_rendered, baking, drawn_lines, properties, reading, session

ENGINE = "FOVEA"


class OfRender(Operator):
    """One that draws the context's scene."""

    @classmethod
    def hindrance(cls, context):
        if problem := native.problem():
            return problem
        if context.scene and followed.follows(context.scene):
            return f"This scene draws the lines of '{followed.of(context.scene).name}': go to that one"
        if context.scene is None or context.scene.camera is None:
            return "The scene has no camera: add one, or make one the scene's active camera"
        fits = context.mode in {"OBJECT", "POSE"}
        return None if fits else "Leave the mode first: this works in Object mode"


@contextmanager
def progress(context):
    """Context with a function progress(share, text) that shows the share in [0, 1] at the pointer."""
    manager = context.window_manager
    manager.progress_begin(0.0, 1.0)
    try:
        yield lambda share, _text: manager.progress_update(share)
    finally:
        manager.progress_end()


class FOVEA_OT_render_lines(OfRender, bpy.types.Operator):
    """Draw the lines alone to a new image with alpha, as a final render of this frame and view layer has them, and open
    it. The scene may use any render engine"""

    bl_idname = "fovea.render_lines"
    bl_label = "Render Line Layer to Image"

    name: bpy.props.StringProperty(name="Name", description="Of the image", default="Lines")

    def invoke(self, context, _event):
        """Opens the image, too, which scripts that execute the operator may not want."""
        done = self.execute(context)
        if done == {"FINISHED"}:
            open_image(context, self.image)
        return done

    def act(self, context):
        with progress(context) as tell:
            drawn = as_rendered.look(context, partial(session.final_image, lines_alone=True, tell=tell))
        if drawn is None:
            raise CannotDraw("Stopped before the lines were drawn")
        image = self.image = image_of(self.name, drawn.lines)
        self.report({"INFO"}, f"The lines are in the image '{image.name}'")


def image_of(name, pixels):
    """A new image from (H, W, 4) float32, scene-linear, premultiplied; packed, so that saving and undo include it."""
    height, width = pixels.shape[:2]
    image = bpy.data.images.new(name, width, height, alpha=True, float_buffer=True)
    image.alpha_mode = "PREMUL"
    image.pixels.foreach_set(np.ascontiguousarray(pixels, np.float32).ravel())
    image.update()
    image.pack()
    return image


def open_image(context, image):
    """Shows an image in an image editor; where there is none, in one that Blender opens as it does for renders, which
    the preferences say (none at all, maybe)."""
    if not _image_editors(context):
        bpy.ops.render.view_show("INVOKE_DEFAULT")
    for editor in _image_editors(context)[:1]:
        editor.image = image


def _image_editors(context):
    areas = (area for window in context.window_manager.windows for area in window.screen.areas)
    editors = (area.spaces.active for area in areas if area.type == "IMAGE_EDITOR")
    return [editor for editor in editors if editor.mode == "VIEW" and not editor.use_image_pin]


class FOVEA_OT_bake_strokes(OfRender, bpy.types.Operator):
    """Make objects of the lines that a final render of this frame and view layer has, one per line set, in a new
    collection. Their points know how strong each line is, what kind of line it is, and how wide and opaque its pen"""

    bl_idname = "fovea.bake_strokes"
    bl_label = "Bake Strokes"

    kind: bpy.props.EnumProperty(
        name="Type",
        description="What is made of the strokes",
        items=[
            ("GREASE_PENCIL", "Grease Pencil", "Strokes with the pens' widths and colors, as the camera sees them"),
            ("MESH", "Mesh", "Vertices and edges"),
        ],
        default="GREASE_PENCIL" if pencils.are_there() else "MESH",
    )

    def act(self, context):
        if self.kind == "GREASE_PENCIL":
            pencils.need("bake with the type Mesh")
        scene, (lines, chosen) = context.scene, as_rendered.look(context, _lines)
        made = baking.objects(lines, chosen, self.kind, scene.frame_current)
        if not made:
            raise CannotDraw("The camera sees no lines")
        collection = bpy.data.collections.new("Lines")
        scene.collection.children.link(collection)
        for obj in made:
            collection.objects.link(obj)
            # Visibility is already resolved, and lines on surfaces would z-fight with them.
            obj.show_in_front = True
        told = f"{len(lines.closed)} strokes in {len(made)} objects of the collection '{collection.name}'"
        if self.kind == "GREASE_PENCIL" and scene.render.engine == ENGINE:
            _hide(context.view_layer, collection)
            told += ", hidden while Fovea draws the same lines: its eye and camera in the outliner show it"
        if not pencils.are_there():
            told += ", as meshes: strokes of Grease Pencil need Blender 4.3 or later"
        self.report({"INFO"}, told)


def _hide(view_layer, collection):
    """Hides a collection of the scene in viewports and renders: Blender draws Grease Pencil over any engine's picture,
    so all lines would be there twice."""
    view_layer.layer_collection.children[collection.name].hide_viewport = True
    collection.hide_render = True


def _lines(engine, depsgraph):
    """(DrawnLines, Style) for a final render's depsgraph."""
    chosen, options = properties.style_of(depsgraph.scene_eval), pipeline.options()
    near = session.lines_near(engine, depsgraph, properties.style_drawn, native.load().CpuBackend(), options)
    found = reading.Reader().read(depsgraph, chosen)
    if not found.snapshot.surfaces:
        raise CannotDraw("There is nothing in the scene that has lines")
    return drawn_lines.of(found, camera.of_render(engine, depsgraph), chosen, options, near), chosen
