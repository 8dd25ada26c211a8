# SPDX-License-Identifier: GPL-3.0-or-later
"""Render > Fovea > Fit Style to Drawing: a new style of the scene, with the lines of an artist's drawing of it."""

from pathlib import Path

import bpy
from bpy_extras.io_utils import ImportHelper

from .. import comparison, fitted_style
from ..scene.operator import TOLD
from ..style import style_data, style_read
from . import style_fit
from .compare_operators import REGISTER
from .line_operators import OfRender


class FOVEA_OT_fit_style(OfRender, bpy.types.Operator, ImportHelper):
    """Give the scene a new style that draws it as a drawing of this frame has it: line definitions on or off, and their
    thresholds. Pens and all else are those of its present style, which stays in the file if it was edited"""

    bl_idname, bl_label = "fovea.fit_style", "Fit Style to Drawing"
    errors = (*TOLD, ValueError, OSError)

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
    completeness: bpy.props.FloatProperty(
        name="Completeness",
        description="Below 1: rather without lines that the drawing does not have; above: rather with all it has",
        default=1.0,
        min=0.5,
        max=2.0,
    )

    def draw(self, _context):
        layout = self.layout
        layout.use_property_split = True
        for name in ("register_by", "tolerance", "completeness"):
            layout.prop(self, name)

    def act(self, context):
        drawing = comparison.read(Path(bpy.path.abspath(self.filepath)))
        scene, tolerance = context.scene, self.tolerance or None
        by = None if self.register_by == "NONE" else self.register_by.lower()
        size = comparison.frame_for(drawing, style_fit.frame_size(scene.render), by)
        judge_of, own = comparison.judge_of(drawing, size, by, tolerance), style_data.of(scene)
        base = style_read.read(own) if own else style_data.default()
        found = style_fit.fit(context, size, fitted_style.names_of(base), base, judge_of, tolerance, self.completeness)
        style_data.use(scene, found.style, f"Fitted from {drawing.name}")
        told = ", ".join(_told(name, value) for name, value in found.thresholds.items() if value is not None)
        self.report(
            {"INFO"},
            f"The style '{scene.fovea.style.name}' has F1 {found.found['f1']:.2f}, the one before "
            f"{found.before['f1']:.2f}: {told}",
        )


def _told(name, value):
    return name if value is True else f"{name} from {value:g}"
