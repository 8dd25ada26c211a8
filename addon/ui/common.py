# SPDX-License-Identifier: GPL-3.0-or-later
"""Base classes of panels, and helpers to draw properties."""

from .. import style
from ..style import style_data, style_groups

ENGINE = "FOVEA"
HEEDED = {  # member of a pen -> whether it has an effect for a given pen
    "texture_anchor": lambda pen: pen.texture != "solid",
    "length_scale": lambda pen: pen.texture != "solid",
    "wobble_length": lambda pen: pen.wobble > 0,
    "seed": lambda pen: pen.wobble > 0,
}


class FoveaPanel:
    """Base of panels in the render tab."""

    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"
    COMPAT_ENGINES = {ENGINE}

    @classmethod
    def poll(cls, context):
        return context.engine in cls.COMPAT_ENGINES

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.use_property_decorate = True
        self.show(self.layout, context)


class StylePanel(FoveaPanel):
    """Of what the scene's own style says."""

    @classmethod
    def poll(cls, context):
        return super().poll(context) and style_data.of(context.scene) is not None


def draw_properties(layout, group, names, heeded=True):
    """Draws properties in a column; grayed out unless `heeded`. Returns the column."""
    column = layout.column()
    column.active = heeded
    for name in names:
        column.prop(group, name)
    return column


def draw_pen(layout, pen, most=None):
    """Draws a pen's groups of properties; `most`: only so many of the first groups, None: all."""
    for group in style_groups.grouped(style.Pen)[:most]:
        column = layout.column()
        for name in group:
            draw_properties(column, pen, (name,), name not in HEEDED or HEEDED[name](pen))
        layout.separator()


def fold(layout, name, title, closed=True, heeded=True):
    """The body of a collapsible section, or None if it is closed; its title is grayed out unless `heeded`."""
    header, body = layout.panel(f"fovea_{name}", default_closed=closed)
    header.active = heeded
    header.label(text=title)
    return body


def fold_switch(layout, name, owner, switch, heeded=True):
    """The body of a collapsible section with a switch in its header, or None if it is closed."""
    header, body = layout.panel(f"fovea_{name}", default_closed=True)
    header.active = heeded
    header.use_property_split = False
    header.prop(owner, switch)
    if body:
        body.active = heeded and getattr(owner, switch)
    return body
