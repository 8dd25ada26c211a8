# SPDX-License-Identifier: GPL-3.0-or-later
"""The renderers that are compared, each set to draw the same lines: contours, creases of 30 degrees, borders.

A renderer is created once per scene; `frame` draws one picture (Line Art: evaluates its modifier once) and is timed;
`told` returns its statistics: strokes, and for Fovea stages and lines_s. `is_slow`: only one frame per scene is drawn,
because frames take minutes. Runs inside Blender."""

import math

import bpy
from scenes import stage

CREASE = math.radians(30)  # between the normals of two faces
LINES = ("contour", "crease", "border")


class Picture:
    """A render engine; a frame is a whole render."""

    engine = "BLENDER_WORKBENCH"
    is_slow = False

    def __init__(self, scene):
        scene.render.engine = self.engine

    def frame(self):
        bpy.ops.render.render()

    def told(self):
        return {}


class Workbench(Picture):
    """Blender's Workbench with default settings (8 antialiasing samples): the cost of a frame without lines."""


class Freestyle(Picture):
    """Freestyle over Workbench. Its silhouettes are Fovea's contours."""

    is_slow = True
    kinds = {"silhouette", "crease", "border"}
    others = {"contour", "external_contour", "edge_mark", "material_boundary", "ridge_valley", "suggestive_contour"}

    def __init__(self, scene):
        super().__init__(scene)
        scene.render.use_freestyle = True
        settings = bpy.context.view_layer.freestyle_settings
        settings.crease_angle = math.pi - CREASE  # it measures between the faces
        lines = settings.linesets[0]  # from the startup file, because a new line set has no line style
        for kind in self.kinds | self.others:
            setattr(lines, f"select_{kind}", kind in self.kinds)

    def frame(self):
        import parameter_editor  # Freestyle's module, on Blender's sys.path

        self.strokes = 0
        parameter_editor.callbacks_lineset_post.append(self.count)
        try:
            super().frame()
        finally:
            parameter_editor.callbacks_lineset_post.remove(self.count)

    def count(self, *_arguments):
        from freestyle.types import Operators

        self.strokes += Operators.get_strokes_size()

    def told(self):
        return {"strokes": self.strokes}


class LineArt:
    """Evaluation of the Line Art modifier only, without a picture: one evaluation per camera movement and update."""

    is_slow = False

    def __init__(self, scene):
        stage.need((4, 3), "Line Art beside Fovea")
        pencils = "grease_pencils_v3" if hasattr(bpy.data, "grease_pencils_v3") else "grease_pencils"  # from 5.0 on
        drawing = getattr(bpy.data, pencils).new("Line Art")
        layer = drawing.layers.new("Lines")
        layer.frames.new(scene.frame_current)
        material = bpy.data.materials.new("Line Art")
        bpy.data.materials.create_gpencil_data(material)
        drawing.materials.append(material)
        self.drawer = bpy.data.objects.new("Line Art", drawing)
        scene.collection.objects.link(self.drawer)
        self.modifier = self.drawer.modifiers.new("Line Art", "LINEART")
        self.modifier.show_viewport = False
        self.modifier.source_type = "SCENE"
        self.modifier.target_layer = layer.name
        self.modifier.target_material = material
        self.modifier.crease_threshold = math.pi - CREASE  # it measures between the faces
        for kind in ("contour", "crease", "intersection", "material", "edge_mark", "loose", "light_contour", "shadow"):
            setattr(self.modifier, f"use_{kind}", kind in ("contour", "crease"))  # its contours include the borders
        bpy.context.view_layer.update()

    def frame(self):
        self.modifier.show_viewport = True  # off until the first frame, so that its evaluation is timed completely
        bpy.context.view_layer.update()

    def told(self):
        drawn = self.drawer.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.layers[0].current_frame()
        return {"strokes": len(drawn.drawing.strokes) if drawn else 0}


class Fovea(Picture):
    engine = "FOVEA"
    backend = "CPU"

    def __init__(self, scene):
        super().__init__(scene)
        scene.fovea.backend = self.backend
        from bl_ext.user_default.fovea.style import style_data

        held = style_data.own(scene)
        style_data.choose_lines(held, LINES)
        for line_set in held.line_sets:
            line_set.kinds.crease_angle = CREASE

    def told(self):
        from bl_ext.user_default.fovea.render import session

        known = session.last_statistics()
        if known.get("backend", "").upper() != self.backend:
            raise RuntimeError(f"Fovea drew with the backend {known.get('backend')} instead of {self.backend}")
        return {"strokes": known["strokes"], "stages": known["stages"], "lines_s": known["lines_s"]}


class FoveaGpu(Fovea):
    backend = "GPU"


BY_NAME = {
    "workbench": Workbench,
    "freestyle": Freestyle,
    "lineart": LineArt,
    "fovea-cpu": Fovea,
    "fovea-gpu": FoveaGpu,
}
