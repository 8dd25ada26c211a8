# SPDX-License-Identifier: GPL-3.0-or-later
"""File > Export > Fovea Drawing: a final render as a file of vectors or layers, or in black and white alone."""

from pathlib import Path

import bpy
from bpy.props import EnumProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from .. import files
from ..scene.operator import TOLD
from ..scene.problem import CannotDraw
from . import vector_settings, vectors
from .line_operators import OfRender, progress

COUNTED = {"ora": "layers", "png": "pixels"}

_of_vectors = vector_settings.annotations("VectorOptions", vector_settings.VECTORS)
_of_screen = vector_settings.annotations("Screen", vector_settings.SCREEN)
_Options = type("_Options", (), {"__annotations__": {**_of_vectors, **_of_screen}})


class FOVEA_OT_export_vectors(OfRender, bpy.types.Operator, ExportHelper, _Options):
    """Write what a final render of this frame and view layer draws: strokes as curves, or pixels on layers or in black
    and white. The scene may use any render engine"""

    bl_idname, bl_label = "fovea.export_vectors", "Export Fovea Drawing"
    bl_options = {"REGISTER"}
    errors = (*TOLD, files.NotWritten)

    filter_glob: StringProperty(default="*.svg;*.pdf;*.dxf;*.ora;*.png", options={"HIDDEN"})
    kind: EnumProperty(name="Format", description="Kind of file", items=lambda _s, _c: vectors.kept_items("KINDS"))

    @property
    def filename_ext(self):
        return f".{self.chosen_kind()}"

    def chosen_kind(self):
        """The kind of file that is asked for, or else that the name of the file says."""
        named = Path(self.filepath).suffix[1:].lower()
        is_named = named in (name for name, *_ in vectors.kept_items("KINDS"))
        return named if is_named and not self.properties.is_property_set("kind") else self.kind

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "kind")
        for name in {"png": _of_screen, "ora": ()}.get(self.chosen_kind(), _of_vectors):
            layout.prop(self, name)
        if self.title_block and self.chosen_kind() not in COUNTED:
            for name in vector_settings.title_fields():
                layout.prop(context.scene.fovea.vectors.titles, name)

    def act(self, context):
        kind = self.chosen_kind()
        if kind == "png":
            asked, remark = vectors.screen(**vector_settings.values(self, _of_screen)), None
        else:
            asked = vectors.options_of(context.scene, **vector_settings.values(self, _of_vectors))
            remark = vectors.remark(asked)
        with progress(context) as tell:
            drawn = vectors.drawing(context, kind, asked, tell=tell)
        if drawn is None:
            raise CannotDraw("Stopped before the lines were drawn")
        vectors.write(drawn, Path(bpy.path.abspath(self.filepath)))
        counted = COUNTED.get(kind, "paths")
        told = f"{drawn.figures[counted]} {counted} are in {Path(self.filepath).name}"
        self.report({"INFO"}, ". ".join(filter(None, (told, remark))))
