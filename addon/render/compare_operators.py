# SPDX-License-Identifier: GPL-3.0-or-later
"""Render > Fovea > Compare with Drawing: the lines of a final render beside a drawing of the same view."""

from functools import partial
from pathlib import Path

import bpy
import numpy as np
from bpy_extras.io_utils import ImportHelper

from .. import comparison, comparison_report, line_arrays, native, pipeline
from ..scene.operator import TOLD
from ..scene.problem import CannotDraw
from . import as_rendered, session
from .line_operators import OfRender, image_of, linear, open_image, progress

REGISTER = (
    ("NONE", "As It Is", "The drawing is a picture of the same frame"),
    ("LINES", "By Its Lines", "It is a scan: it is moved and turned so that its lines meet those of the scene"),
    ("MARKS", "By Marks", "It is a scan of a prompt sheet, which has discs around the frame"),
)
TOLD_OF = {"precision": "precision", "recall": "recall", "f1": "F1"}


class OfDrawing(OfRender, ImportHelper):
    """One that draws the context's scene beside a drawing of the same view."""

    errors = (*TOLD, ValueError, OSError)
    shown = ("register_by", "tolerance")

    filter_glob: bpy.props.StringProperty(default="*.png;*.svg;*.npz", options={"HIDDEN"})
    register_by: bpy.props.EnumProperty(
        name="Register", description="How the drawing lies over the render", items=REGISTER
    )
    tolerance: bpy.props.FloatProperty(
        name="Tolerance",
        description="Distance that counts as near, in pixels; 0: 0.42 % of the frame's diagonal",
        min=0.0,
        soft_max=20.0,
    )

    def draw(self, _context):
        layout = self.layout
        layout.use_property_split = True
        for name in self.shown:
            layout.prop(self, name)

    def asked(self):
        """(Drawing of the file, one of comparison.REGISTERED or None, tolerance [px] or None)."""
        by = None if self.register_by == "NONE" else self.register_by.lower()
        return comparison.read(Path(bpy.path.abspath(self.filepath))), by, self.tolerance or None


class FOVEA_OT_compare_drawing(OfDrawing, bpy.types.Operator):
    """Compare the visible lines of a final render of this frame and view layer with a drawing, and show both in a new
    image: gray where they agree, blue what the scene alone has, red what the drawing alone has"""

    bl_idname, bl_label = "fovea.compare_drawing", "Compare with Drawing"

    def act(self, context):
        drawing, by, tolerance = self.asked()
        compared = comparison.of_drawings([lines_of_render(context), drawing], tolerance, by)
        overlay = comparison_report.overlay(compared.a, compared.judges[0], compared.found["tolerance_px"])
        image = image_of(f"Compared with {drawing.name}", linear(overlay))
        if not bpy.app.background:
            open_image(context, image)
        told = ", ".join(f"{name} {compared.found[key]:.2f}" for key, name in TOLD_OF.items())
        self.report({"INFO"}, f"The scene's lines have {told}; both are in the image '{image.name}'")


def lines_of_render(context):
    """The comparison.Drawing of the visible lines of a final render of the context's frame and view layer."""
    with progress(context) as tell:
        lines = as_rendered.look(context, partial(session.final, make=_lines, tell=tell))
    if lines is None:
        raise CannotDraw("Stopped before the lines were drawn")
    return lines[1]


def _lines(found, seen, chosen, backend, options, progress, cancel, near):
    """The comparison.Drawing of what session.draw would draw: visible runs that line thinning leaves."""
    beside = {"colors": found.colors, "notes": found.notes, "near": near, "progress": progress, "cancel": cancel}
    frame = pipeline.frame(found.placed, seen, chosen, backend, options, **beside)
    with native.refusals():
        frame.thin()
        return comparison.of_lines("the scene", line_arrays.seen(frame, np.eye(4)), (seen.width, seen.height))
