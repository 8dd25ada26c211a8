# SPDX-License-Identifier: GPL-3.0-or-later
"""File > Export > Fovea Drawing: the strokes of a final render as a file of vectors."""

from pathlib import Path

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from .. import files
from ..scene.operator import TOLD
from ..scene.problem import CannotDraw
from . import vectors
from .line_operators import OfRender, progress

CHOSEN = ("sheet", "margin", "to_scale", "tolerance", "widths", "ground", "plotter")  # of VectorOptions


class FOVEA_OT_export_vectors(OfRender, bpy.types.Operator, ExportHelper):
    """Write the strokes that a final render of this frame and view layer has as curves. The scene may use any render
    engine"""

    bl_idname, bl_label = "fovea.export_vectors", "Export Fovea Drawing"
    bl_options = {"REGISTER"}
    errors = (*TOLD, files.NotWritten)

    filter_glob: StringProperty(default="*.svg;*.pdf;*.dxf", options={"HIDDEN"})
    kind: EnumProperty(name="Format", description="Kind of file", items=lambda _s, _c: vectors.kept_items("VECTORS"))
    sheet: EnumProperty(
        name="Paper",
        description="Size of the paper, which lies as the picture does",
        items=lambda _s, _c: vectors.kept_items("SHEETS"),
    )
    margin: FloatProperty(
        name="Margin", description="Left free around the picture on a sheet [mm]", default=10.0, min=0.0, max=1000.0
    )
    to_scale: BoolProperty(
        name="To Scale",
        description="On a sheet of paper, too, the picture is as large as the style's paper says",
        default=False,
    )
    tolerance: FloatProperty(
        name="Tolerance",
        description="How far curves may lie beside the lines that they stand for [mm]; below 0.002: no curves",
        default=0.02,
        min=0.0,
        max=10.0,
        soft_max=1.0,
        precision=3,
    )
    widths: EnumProperty(
        name="Changing Widths",
        description="What becomes of strokes whose width changes",
        items=lambda _s, _c: vectors.kept_items("WIDTHS"),
    )
    ground: BoolProperty(
        name="Paper and Colors",
        description="The color of the paper, and colors below the lines as a picture",
        default=True,
    )
    plotter: BoolProperty(
        name="For a Plotter",
        description="Lines of one width in an order of short ways, joined where they meet, each once",
        default=False,
    )

    @property
    def filename_ext(self):
        return f".{self.chosen_kind()}"

    def chosen_kind(self):
        """The kind of file that is asked for, or else that the name of the file says."""
        named = Path(self.filepath).suffix[1:].lower()
        is_named = named in (name for name, *_ in vectors.kept_items("VECTORS"))
        return named if is_named and not self.properties.is_property_set("kind") else self.kind

    def act(self, context):
        asked = vectors.options(**{name: getattr(self, name) for name in CHOSEN})
        with progress(context) as tell:
            drawn = vectors.drawing(context, self.chosen_kind(), asked, tell=tell)
        if drawn is None:
            raise CannotDraw("Stopped before the lines were drawn")
        vectors.write(drawn, Path(bpy.path.abspath(self.filepath)))
        self.report({"INFO"}, f"{drawn.figures['paths']} paths are in {Path(self.filepath).name}")
