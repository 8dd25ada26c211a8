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
UNITS = (
    ("PIXELS", "Pixels", "Of the frame"),
    ("MILLIMETERS", "Millimeters", "On paper, of the size that the drawings' files say, or that is given here"),
)
# How sentences of the commands name what is a property here.
NAMES = {"--paper-width": "Paper Width", "--tolerance": "Tolerance", "--register": "Register"}
TOLD_OF = {"precision": "precision", "recall": "recall", "f1": "F1"}


class OfDrawing(OfRender, ImportHelper):
    """One that draws the context's scene beside a drawing of the same view."""

    errors = (*TOLD, ValueError, OSError)
    shown = ("register_by", "tolerance", "unit", "paper_width")

    filter_glob: bpy.props.StringProperty(default="*.png;*.svg;*.npz", options={"HIDDEN"})
    register_by: bpy.props.EnumProperty(
        name="Register", description="How the drawing lies over the render", items=REGISTER
    )
    tolerance: bpy.props.FloatProperty(
        name="Tolerance",
        description="Distance that counts as near; 0: 0.42 % of the frame's diagonal",
        min=0.0,
        soft_max=20.0,
    )
    unit: bpy.props.EnumProperty(name="Unit", description="What the tolerance is measured in", items=UNITS)
    paper_width: bpy.props.FloatProperty(
        name="Paper Width",
        description="How wide the frame is on paper, in millimeters; 0: as the drawings' files say",
        min=0.0,
        soft_max=1000.0,
    )
    files: bpy.props.CollectionProperty(
        type=bpy.types.OperatorFileListElement, options={"HIDDEN", "SKIP_SAVE"}, description="Names in the folder"
    )
    directory: bpy.props.StringProperty(
        subtype="DIR_PATH", options={"HIDDEN", "SKIP_SAVE"}, description="Folder of several drawings"
    )

    def draw(self, _context):
        layout = self.layout
        layout.use_property_split = True
        for name in self.shown:
            if name != "paper_width" or self.unit == "MILLIMETERS":
                layout.prop(self, name)

    @property
    def paths(self):
        """Of the drawings that are chosen."""
        folder = Path(bpy.path.abspath(self.directory))
        names = [file.name for file in self.files if file.name] if self.directory else []
        return [folder / name for name in names] or [Path(bpy.path.abspath(self.filepath))]

    @property
    def near(self):
        """The tolerance: pixels, comparison.Millimeters, or None."""
        if self.unit == "MILLIMETERS" and self.tolerance:
            return comparison.Millimeters(self.tolerance, self.paper_width or None)
        return self.tolerance or None

    def asked(self):
        """(Drawings of the files, one of comparison.REGISTERED or None, tolerance)."""
        by = None if self.register_by == "NONE" else self.register_by.lower()
        return [comparison.read(path) for path in self.paths], by, self.near

    @staticmethod
    def sentence(error):
        told = str(error)
        for word, name in NAMES.items():
            told = told.replace(word, name)
        return told


class FOVEA_OT_compare_drawing(OfDrawing, bpy.types.Operator):
    """Compare the visible lines of a final render of this frame and view layer with a drawing, or several, and show
    both in a new image: gray where they agree, blue what the scene alone has, red what the drawing alone has"""

    bl_idname, bl_label = "fovea.compare_drawing", "Compare with Drawing"

    def act(self, context):
        drawings, by, tolerance = self.asked()
        compared = lines_of_render(context, lambda lines: comparison.of_drawings([lines, *drawings], tolerance, by))
        near, images = compared.found["tolerance_px"], []
        for drawing, judge in zip(drawings, compared.judges):
            overlay = comparison_report.overlay(compared.a, judge, near)
            images.append(image_of(f"Compared with {drawing.name}", linear(overlay)))
        if not bpy.app.background:
            open_image(context, images[0])
        told = ", ".join(f"{name} {compared.found[key]:.2f}" for key, name in TOLD_OF.items())
        named = " and ".join(f"'{image.name}'" for image in images)
        each = "both are in the image" if len(images) == 1 else "means of all drawings, which are in the images"
        self.report({"INFO"}, f"The scene's lines have {told} within {near:.1f} pixels; {each} {named}")


def lines_of_render(context, use=None):
    """The comparison.Drawing of the visible lines of a final render of the context's frame and view layer, or what
    use(Drawing) makes of it, which the user may cancel, too."""
    with progress(context) as tell:
        made = as_rendered.look(context, partial(session.final, make=partial(_lines, use=use), tell=tell))
    if made is None:
        raise CannotDraw("Stopped before it was done: nothing has changed")
    return made[1]


def _lines(found, seen, chosen, backend, options, progress, cancel, near, use=None):
    """The comparison.Drawing of what session.draw would draw: visible runs that line thinning leaves; or what
    use(Drawing) makes of it."""
    beside = {"colors": found.colors, "notes": found.notes, "near": near, "progress": progress, "cancel": cancel}
    frame = pipeline.frame(found.placed, seen, chosen, backend, options, **beside)
    with native.refusals():
        frame.thin()
        lines = comparison.of_lines("the scene", line_arrays.seen(frame, np.eye(4)), (seen.width, seen.height))
    return use(lines) if use else lines
