# SPDX-License-Identifier: GPL-3.0-or-later
"""Render > Fovea > Fit Style to Drawing: a new style of the scene, with the lines of an artist's drawing of it."""

import bpy

from .. import comparison, fitted_style
from ..scene import camera
from ..style import style_data, style_read
from . import style_fit
from .compare_operators import OfDrawing


class FOVEA_OT_fit_style(OfDrawing, bpy.types.Operator):
    """Give the scene a new style that draws it as a drawing of this frame has it, or several: line definitions on or
    off, their thresholds, the width and darkness of pens, overshoot and wobble. All else is that of its present style,
    which stays in the file if it was edited"""

    bl_idname, bl_label = "fovea.fit_style", "Fit Style to Drawing"
    shown = (*OfDrawing.shown, "completeness", "pens")

    completeness: bpy.props.FloatProperty(
        name="Completeness",
        description="Below 1: rather without lines that the drawing does not have; above: rather with all it has",
        default=1.0,
        min=0.5,
        max=2.0,
    )
    pens: bpy.props.BoolProperty(
        name="Pens",
        description="Pens get the width, darkness, overshoot and wobble of the drawing's strokes, where it shows them",
        default=True,
    )

    def act(self, context):
        drawings, by, tolerance = self.asked()
        scene = context.scene
        size = comparison.frame_for(drawings, camera.frame_size(scene.render), by)
        tolerance = comparison.tolerance_in(drawings, size, by, tolerance)
        judges_of, own = comparison.judges_of(drawings, size, by, tolerance), style_data.of(scene)
        base = style_read.read(own) if own else style_data.default()
        found = style_fit.fit(
            context, size, fitted_style.names_of(base), base, judges_of, tolerance, self.completeness, self.pens
        )
        style_data.use(scene, found.style, f"Fitted from {' and '.join(drawing.name for drawing in drawings)}")
        told = [_told(name, value) for name, value in found.thresholds.items() if value is not None]
        told += [f"pen of '{look.name}' {look.width:.1f} px wide" for look in found.looks]
        told += [f"'{hand.name}' {_told_of_hand(hand)}" for hand in found.hands if hand.overshoot or hand.wobble]
        held_out = "drawings" if len(drawings) > 1 else "parts"
        self.report(
            {"INFO"},
            f"The style '{scene.fovea.style.name}' has F1 {found.found['f1']:.2f}, the one before "
            f"{found.before['f1']:.2f}, of {held_out} held out of the fit {found.held_out['f1']:.2f}: "
            f"{', '.join(told)}",
        )


def _told(name, value):
    return name if value is True else f"{name} from {value:g}"


def _told_of_hand(hand):
    parts = {"overshoots": hand.overshoot, "wobbles": hand.wobble}
    return " and ".join(f"{word} by {value:.1f} px" for word, value in parts.items() if value)
