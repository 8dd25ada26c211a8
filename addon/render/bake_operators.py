# SPDX-License-Identifier: GPL-3.0-or-later
"""Bake Strokes: the lines of final renders as objects, of one frame or of an animation."""

import bpy
from bpy.props import EnumProperty, IntProperty

from .. import native, pipeline
from ..scene import camera, pencils
from ..scene.problem import CannotDraw
from . import as_rendered, drawn_lines, holds, mesh_bake, near_frames, pencil_bake, properties, reading, session
from .line_operators import OfRender, progress

ENGINE = "FOVEA"
MOST_MEMORY = 2e9  # bytes that the lines of all frames may take
FRAME = {"min": -1048574, "max": 1048574}


class FOVEA_OT_bake_strokes(OfRender, bpy.types.Operator):
    """Make objects of the strokes that a final render of this view layer has: Grease Pencil with a layer per line set,
    of one frame or of an animation, or meshes. What was baked before is replaced, and nothing else"""

    bl_idname = "fovea.bake_strokes"
    bl_label = "Bake Strokes"

    kind: EnumProperty(
        name="Type",
        description="What is made of the strokes",
        items=[
            ("GREASE_PENCIL", "Grease Pencil", "Strokes with the pens' widths and colors, as the camera sees them"),
            ("MESH", "Mesh", "Vertices and edges, one object per line set, of the current frame"),
        ],
        default="GREASE_PENCIL" if pencils.are_there() else "MESH",
    )
    frames: EnumProperty(
        name="Frames",
        description="What is baked as Grease Pencil",
        items=[
            ("CURRENT", "Current Frame", "It stands until the next key"),
            ("RANGE", "Frame Range", "An animation"),
        ],
    )
    frame_start: IntProperty(name="Start", description="First frame that is baked", default=1, **FRAME)
    frame_end: IntProperty(name="End", description="Last frame that is baked", default=1, **FRAME)
    step: IntProperty(name="Step", description="2: on twos, each drawing stands for two frames", default=1, min=1)
    into: EnumProperty(
        name="Into",
        description="Where strokes of Grease Pencil go",
        items=[
            ("BAKED", "Baked Object", "The object of this scene that was baked before, whose strokes are replaced"),
            ("NEW", "New Object", "One more object"),
        ],
    )

    def invoke(self, context, _event):
        self.frame_start, self.frame_end = self.span(context.scene)
        return context.window_manager.invoke_props_dialog(self, confirm_text="Bake")

    def draw(self, _context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "kind")
        if self.kind == "MESH":
            return
        layout.prop(self, "frames")
        if self.frames == "RANGE":
            column = layout.column(align=True)
            for name in ("frame_start", "frame_end", "step"):
                column.prop(self, name)
        layout.prop(self, "into")

    def act(self, context):
        numbers = self.numbers(context.scene)
        with progress(context) as tell:
            frames, style = as_rendered.look(context, lambda *of: _lines(*of, numbers, tell))
        if not any(len(lines.closed) for lines in frames.values()):
            raise CannotDraw("The camera sees no lines")
        told = self.meshes(context, frames, style) if self.kind == "MESH" else self.pencil(context, frames, style)
        self.report({"INFO"}, told)

    def span(self, scene):
        """The first and the last frame of a range: those of the scene, where others are not given."""
        given = self.properties.is_property_set
        return tuple(getattr(self if given(name) else scene, name) for name in ("frame_start", "frame_end"))

    def numbers(self, scene):
        """The numbers of the frames that are baked. CannotDraw where they make no sense."""
        if self.kind == "GREASE_PENCIL":
            pencils.need("bake with the type Mesh")
        if self.frames == "CURRENT":
            return range(scene.frame_current, scene.frame_current + 1)
        if self.kind == "MESH":
            raise CannotDraw("Meshes are of one frame: bake an animation with the type Grease Pencil")
        first, last = self.span(scene)
        if last < first:
            raise CannotDraw(f"There are no frames from {first} to {last}: set End to Start or later")
        return range(first, last + 1, self.step)

    def meshes(self, context, frames, style):
        (lines,) = frames.values()
        made = mesh_bake.objects(lines, style)
        collection = _linked(context.scene, made)
        told = f"{len(lines.closed)} strokes in {len(made)} objects of the collection '{collection.name}'"
        if not pencils.are_there():
            told += ", as meshes: strokes of Grease Pencil need Blender 4.3 or later"
        return told

    def pencil(self, context, frames, style):
        scene, obj = context.scene, None
        if self.into == "BAKED":
            obj = pencil_bake.found_in(scene)
        is_new, hidden = obj is None, ""
        if is_new:
            obj = pencil_bake.new_object("Lines")
        span = self.span(scene) if self.frames == "RANGE" else None
        pencil_bake.bake(obj, frames, span, style)
        if is_new:
            collection = _linked(scene, [obj])
            if scene.render.engine == ENGINE:
                _hide(context.view_layer, collection)
                hidden = ", hidden while Fovea draws the same lines: its eye and camera in the outliner show it"
        of_frames = f" of {len(frames)} frames" if span else ""
        return f"{sum(len(lines.closed) for lines in frames.values())} strokes{of_frames} in '{obj.name}'{hidden}"


def _linked(scene, objects):
    """A new collection of a scene with new objects, which get no lines themselves. Their visibility is resolved
    already, and lines on surfaces would z-fight with them, so they are in front."""
    collection = bpy.data.collections.new("Lines")
    scene.collection.children.link(collection)
    for obj in objects:
        collection.objects.link(obj)
        obj.fovea.usage, obj.show_in_front = "IGNORE", True
    return collection


def _hide(view_layer, collection):
    """Hides a collection of the scene in viewports and renders: Blender draws Grease Pencil over any engine's picture,
    so all lines would be there twice."""
    view_layer.layer_collection.children[collection.name].hide_viewport = True
    collection.hide_render = True


def _lines(engine, depsgraph, numbers, tell):
    """({frame number: DrawnLines}, Style of the first frame) for a final render's depsgraph."""
    core, reader, found, used, style, anything = native.load(), reading.Reader(), {}, 0, None, False
    cancel, current = core.Cancel(), depsgraph.scene.frame_current
    with session.watched(engine, cancel), cancel, near_frames.other_frames(engine, depsgraph.scene) as go:
        for i, number in enumerate(numbers):
            tell(i / len(numbers), "")
            go(number - current)
            try:
                lines, chosen, read = _lines_now(engine, depsgraph, reader, cancel)
            except core.Cancelled as stopped:
                raise CannotDraw("Stopped before the strokes were baked: nothing was changed") from stopped
            style, anything = style or chosen, anything or bool(read.snapshot.surfaces)
            found[number], used = lines, used + lines.memory
            if used > MOST_MEMORY:
                raise CannotDraw(
                    f"The strokes until frame {number} need over 2 GB: bake fewer frames, or a larger step"
                )
    if not anything:
        raise CannotDraw("There is nothing in the scene that has lines")
    return found, style


def _lines_now(engine, depsgraph, reader, cancel):
    """(DrawnLines, Style, Read) of the frame that a final render's depsgraph is evaluated at."""
    styled, backend, options = properties.style_drawn, native.load().CpuBackend(), pipeline.options()
    animation = styled(depsgraph).animation
    with holds.held(engine, depsgraph, animation):
        chosen, view = styled(depsgraph), camera.of_render(engine, depsgraph)
        near = session.lines_near(engine, depsgraph, styled, backend, options, cancel)
        read = reader.read(depsgraph, chosen, cancel=cancel)
    options = options.replace(boil_drawing=animation.boil_drawing(depsgraph.scene.frame_current))
    return drawn_lines.of(read, view, chosen, options, near, cancel), chosen, read
