# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts and other add-ons call: surfaces, fields and lines as arrays (scene/api.py), and drawings as SVG.

from bl_ext.user_default.fovea.render import api as fovea

svg = fovea.drawing(bpy.context.scene.camera, "technical", sheet="a4")
"""

import bpy

from .. import style as styles
from ..scene.api import definitions, fields, lines, surface, surfaces
from ..scene.problem import CannotDraw
from . import vectors

__all__ = ["definitions", "drawing", "fields", "lines", "surface", "surfaces"]


def drawing(camera=None, style=None, **options):
    """The drawing that a final render of the current frame and view layer shows, as the text of an SVG file: layers of
    line sets with visible and hidden lines, a path for each stroke, in millimeters.

    camera: an object that sees it, None: the scene's. style: a Style, the name of a shipped one or a .json file,
    or None: the scene's own. options: those of vectors, as sheet="a4", margin=10.0, tolerance=0.02, widths="center",
    ground=False, plotter=True, title_block=True, titles={"title": "Plan"}, of which those that are not given are the
    scene's. The scene may use any render engine, and stays as it is. CannotDraw, or a ValueError,
    says in a sentence what cannot be drawn."""
    chosen = styles.named(style) if isinstance(style, str) else style
    asked = vectors.options_of(bpy.context.scene, **options)
    made = vectors.drawing(bpy.context, "svg", asked, camera=camera, chosen=chosen)
    if made is None:
        raise CannotDraw("Stopped before the lines were drawn")
    return made.file().decode()
