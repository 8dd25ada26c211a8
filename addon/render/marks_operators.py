# SPDX-License-Identifier: GPL-3.0-or-later
"""Bake Marks: marks of lines of the view, handed on through all frames of a shot."""

from functools import partial

import bpy

from .. import files, native, pipeline
from ..scene import camera, followed
from ..scene.problem import CannotDraw
from . import as_rendered, baked_marks, methods, near_frames, properties, session
from .line_operators import OfRender, progress


class FOVEA_OT_bake_marks(OfRender, bpy.types.Operator):
    """Find the lines of all frames of the scene's range, as a final render of this view layer has them, hand their
    marks on from each to the next, and write these to a file in a folder beside the Blender file. Renders take them
    from there where the style says Baked Marks"""

    bl_idname = "fovea.bake_marks"
    bl_label = "Bake Marks"
    bl_options = {"REGISTER"}
    errors = (*OfRender.errors, files.NotWritten)

    def act(self, context):
        scene = context.scene
        path = baked_marks.place(scene, context.view_layer)
        if path is None:
            raise CannotDraw("Save the Blender file first: marks are baked to a file beside it")
        held = properties.style_of(scene).animation.held(scene.frame_start)
        numbers = range(held, scene.frame_end + 1)
        with progress(context) as tell:
            found = as_rendered.look(context, partial(_handed_on, numbers=numbers, tell=tell))
        if not any(content for content, _ in found.values()):
            raise CannotDraw(
                "No line of the view has marks: fix the textures of pens to paths (Texture Fixed To), "
                "and switch Baked Marks or Marks Over Frames on"
            )
        baked_marks.write(path, found)
        self.report({"INFO"}, f"Marks of {len(found)} frames are in {path}")


def _handed_on(engine, depsgraph, numbers, tell):
    """{frame number: (content, marks)} for a final render's depsgraph."""
    core, settings = native.load(), followed.of(depsgraph.scene).fovea
    cancel, current = core.Cancel(), depsgraph.scene.frame_current + depsgraph.scene.frame_subframe
    backend, visibility = methods.choose(engine, settings, in_viewport=False)
    options = pipeline.options(visibility=visibility, **methods.quality(settings))
    made, before, seen_before, marks = {}, None, None, None
    with session.watched(engine, cancel), cancel, near_frames.other_frames(engine, depsgraph.scene) as go:
        for i, number in enumerate(numbers):
            tell(i / len(numbers), "")
            go(number - current)
            try:
                found = session.lines_now(engine, depsgraph, properties.style_drawn, backend, options, cancel)
            except core.Cancelled as stopped:
                raise CannotDraw("Stopped before the marks were baked: nothing was written") from stopped
            if not found or not found.near_lines.marks_content:
                before = None
                continue
            lines, seen = found.near_lines, camera.chosen(engine, depsgraph).name_full
            cut = before is None or seen != seen_before
            marks = lines.own_marks() if cut else lines.marks_handed_on(before, marks)
            made[number] = lines.marks_content, marks
            before, seen_before = lines, seen
    return made
