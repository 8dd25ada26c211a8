# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels in the render tab of other engines: lines over their renders, with Fovea's panels of style, lines and focus
below."""

import bpy

from ..render import lines_over, lines_over_check, lines_scenes
from ..scene import followed
from .animation import RENDER_PT_fovea_animation
from .common import ENGINE, FoveaPanel, copied
from .effects import RENDER_PT_fovea_effects
from .elision import RENDER_PT_fovea_elision
from .focus import RENDER_PT_fovea_focus
from .lines import RENDER_PT_fovea_lines
from .style import RENDER_PT_fovea_style
from .vectors import RENDER_PT_fovea_vectors

BELOW = (
    *(RENDER_PT_fovea_style, RENDER_PT_fovea_lines, RENDER_PT_fovea_focus, RENDER_PT_fovea_effects),
    *(RENDER_PT_fovea_elision, RENDER_PT_fovea_animation, RENDER_PT_fovea_vectors),
)
_registered = []


class RENDER_PT_fovea_lines_over(FoveaPanel, bpy.types.Panel):
    bl_label = "Fovea Lines"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def fits(cls, context):
        return context.engine != ENGINE

    def draw_header(self, context):
        on = lines_over.is_on(context.scene)
        name, icon = ("_remove", "CHECKBOX_HLT") if on else ("", "CHECKBOX_DEHLT")
        self.layout.operator(f"fovea.lines_over{name}", text="", icon=icon, emboss=False)

    def show(self, layout, context):
        scene = context.scene
        if not lines_over.is_on(scene):
            return
        failure = lines_scenes.failure(scene)
        for sentence in (*lines_over_check.problems(scene), *((f"Last render: {failure}",) if failure else ())):
            layout.label(text=f"{sentence[0].upper()}{sentence[1:]}", icon="ERROR")
        _draw_blend(layout, scene.fovea, lines_over.node(scene, lines_over.OVER))
        layout.prop(scene.fovea, "lines_in_viewports")
        layout.operator("fovea.lines_over_repair", text="Repair")


class VIEWLAYER_PT_fovea_lines_over(FoveaPanel, bpy.types.Panel):
    bl_label = "Fovea Lines"
    bl_context = "view_layer"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def fits(cls, context):
        return context.engine != ENGINE and len(context.scene.view_layers) > 1

    def draw_header(self, context):
        on = lines_scenes.of(context.scene, context.view_layer)
        icon = "CHECKBOX_HLT" if on else "CHECKBOX_DEHLT"
        self.layout.operator("fovea.lines_over_layer", text="", icon=icon, emboss=False)

    def show(self, layout, context):
        scene, layer = context.scene, context.view_layer
        if lines := lines_scenes.of(scene, layer):
            layout.prop(lines.fovea, "style", text="Own Style", placeholder="That of the scene")
            _draw_blend(layout, lines.fovea, lines_over.node(scene, lines_over.OVER, layer))


def _draw_blend(layout, settings, over):
    """Draws how lines lie over a picture, if there is a node that lays them over it."""
    if over:
        layout.prop(settings, "lines_blend")
        layout.prop(over.inputs["Opacity"], "default_value", text="Opacity")


class RENDER_PT_fovea_follower(FoveaPanel, bpy.types.Panel):
    """Of a scene that draws another one's lines."""

    bl_label = "Lines of Another Scene"
    bl_options = {"HIDE_HEADER"}

    @classmethod
    def fits(cls, context):
        return followed.follows(context.scene)

    def show(self, layout, context):
        layout.label(text=f"Draws the lines of '{context.scene.fovea.lines_of.name}'", icon="INFO")


def _below(panel):
    """A class with the contents of one of Fovea's panels, below that of the lines over renders."""

    def fits(cls, context):
        return RENDER_PT_fovea_lines_over.fits(context) and lines_over.is_on(context.scene)

    return copied(
        panel,
        panel.__name__.replace("fovea_", "fovea_over_"),
        bl_parent_id=RENDER_PT_fovea_lines_over.__name__,
        bl_options={"DEFAULT_CLOSED"},
        fits=classmethod(fits),
    )


def register():
    for panel in BELOW:
        _registered.append(_below(panel))
        bpy.utils.register_class(_registered[-1])


def unregister():
    while _registered:
        bpy.utils.unregister_class(_registered.pop())
