# SPDX-License-Identifier: GPL-3.0-or-later
"""Base classes of panels, and helpers to draw properties."""

import re

import bpy

from .. import style
from ..scene import followed
from ..style import style_curves, style_data, style_groups

ENGINE = "FOVEA"
OF_ITSELF = {"bl_idname", "bl_parent_id", "bl_rna", "__dict__", "__weakref__"}  # members of a panel that no copy has
HEEDED = {  # member of a pen -> whether it has an effect for a given pen
    "texture_anchor": lambda pen: pen.texture != "solid" or pen.wobble > 0 or _acts(pen, "noise"),
    "length_scale": lambda pen: pen.texture != "solid",
    "wobble_length": lambda pen: pen.wobble > 0,
    "seed": lambda pen: pen.wobble > 0 or _acts(pen, "noise"),
    "second_color": lambda pen: pen.along_color.strength + pen.nib_color + pen.distance_color + pen.noise_color > 0,
    "nib_angle": lambda pen: _acts(pen, "nib"),
    "distance_near": lambda pen: _acts(pen, "distance"),
    "distance_far": lambda pen: _acts(pen, "distance"),
    "noise_length": lambda pen: _acts(pen, "noise"),
    "paint_width_name": lambda pen: pen.paint_width in NAMED,
    "paint_opacity_name": lambda pen: pen.paint_opacity in NAMED,
    "paint_color_name": lambda pen: pen.paint_color in NAMED,
}
NAMED = {"VERTEX_GROUP", "ATTRIBUTE"}  # what of a pen's paints has a name
# Group of a pen's members that is folded -> title.
FOLDED = {"along": "Along the Stroke", "nib": "Nib", "distance": "Distance", "noise": "Noise", "paint": "Painted"}


def _acts(pen, group):
    """Whether a modifier of a pen changes anything."""
    return any(getattr(pen, f"{group}_{what}") > 0 for what in ("width", "opacity", "color"))


class FoveaPanel:
    """Base of panels in the render tab."""

    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"
    COMPAT_ENGINES = {ENGINE}
    of_followers = False  # whether scenes that draw the lines of another one have it, too

    @classmethod
    def poll(cls, context):
        return cls.fits(context)

    @classmethod
    def fits(cls, context):
        """Whether the panel is for the context's engine and scene."""
        of_scene = cls.of_followers or not followed.follows(context.scene)
        return context.engine in cls.COMPAT_ENGINES and of_scene

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.use_property_decorate = True
        self.show(self.layout, context)


def copied(panel, name, **members):
    """A class of this name with the contents of a registered panel. Not a subclass: registered, it would take the
    panel's place."""
    contents = {key: value for key, value in vars(panel).items() if key not in OF_ITSELF}
    return type(name, panel.__bases__, contents | members)


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
    where = re.sub(r"\W|\d", "_", pen.path_from_id())
    for group, names in list(style_groups.grouped(style.Pen).items())[:most]:
        body = fold(layout, f"{where}_{group}", FOLDED[group]) if group in FOLDED else layout
        if body is None:
            continue
        column = body.column()
        for name in names:
            row = column.row(align=True)
            heeded = name not in HEEDED or HEEDED[name](pen)
            if group == "paint" and name.endswith("_name"):
                row.active = heeded
                of_groups = getattr(pen, name.removesuffix("_name")) == "VERTEX_GROUP"
                draw_painted(row, pen, name, bpy.context.object, of_groups)
                continue
            draw_properties(row, pen, (name,), heeded)
            if name == "width":
                chosen = row.operator_menu_enum("fovea.pen_width", "width", text="", icon="DOWNARROW_HLT")
                chosen.pen = pen.path_from_id()
        for declared in style_groups.transfers(style.Pen).values():
            if declared["group"] == group:
                _draw_curve_of_pen(body, pen, where, declared)
        body.separator()


def draw_painted(layout, owner, name, obj, of_groups=False):
    """Draws the name of what is painted, with a search among the attributes, or the vertex groups, of an object that is
    a mesh."""
    if obj is None or obj.type != "MESH":
        layout.prop(owner, name)
    elif of_groups:
        layout.prop_search(owner, name, obj, "vertex_groups", icon="GROUP_VERTEX")
    else:
        layout.prop_search(owner, name, obj.data, "attributes", icon="GROUP_VCOL")


def _draw_curve_of_pen(layout, pen, where, declared):
    """Draws a transfer function along strokes, with its curve if it has one."""
    name, tree = declared["name"], pen.id_data
    transfer = getattr(pen, name)
    if body := fold(layout, f"{where}_{name}", declared["label"], heeded=transfer.strength > 0):
        draw_properties(body, transfer, ("start", "end", "strength"))
        if node := tree.nodes.get(style_curves.node_name(pen.curves, name)):
            body.template_curve_mapping(node, "mapping")
        else:
            added = body.operator("fovea.pen_curve_add", icon="FCURVE")
            added.pen, added.effect = pen.path_from_id(), name


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
