# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel: the style's line sets, and the filters, kinds and pens of the selected one."""

import bpy

from ..scene.line_kinds import definitions
from ..style import FILTERS, style_data
from ..style.line_set_operators import edited, edited_hidden
from ..style.renamed import KINDS
from .common import StylePanel, draw_pen, draw_properties, fold, fold_switch

# The registry's scope of a definition, which says what its lines depend on -> title.
SCOPES = {"view": "View-Dependent", "surface": "Surface", "scene": "Object and Image"}


class FOVEA_UL_line_sets(bpy.types.UIList):
    """Line sets by name."""

    def draw_item(self, _context, layout, _data, item, _icon, _active_data, _active, _index=0, _flag=0):
        layout.prop(item, "name", text="", emboss=False, icon="GREASEPENCIL")


class FOVEA_UL_hidden_pens(bpy.types.UIList):
    """Hidden pens by what hides their lines."""

    def draw_item(self, _context, layout, _data, item, _icon, _active_data, _active, _index=0, _flag=0):
        last = f"to {item.last}" if item.last else "or more"
        layout.label(text=f"Hidden by {item.first} {last}" if item.last != item.first else f"Hidden by {item.first}")


class RENDER_PT_fovea_lines(StylePanel, bpy.types.Panel):
    bl_label = "Lines"
    of_followers = True  # they may have a style of their own

    def show(self, layout, context):
        held = style_data.of(context.scene).fovea
        draw_list(layout, held)
        if line_set := edited(held):
            draw_pen_of_visible(layout, line_set)
            draw_kinds(layout, held, line_set)
            draw_filter(layout, line_set)
            draw_other_pens(layout, context.scene, line_set)


def draw_list(layout, held):
    side = _draw_list(layout, held, "line_sets", "line_set_index", "line_set", rows=3)
    side.operator("fovea.line_set_duplicate", text="", icon="DUPLICATE")
    side.operator("fovea.line_set_move", text="", icon="TRIA_UP").direction = "UP"
    side.operator("fovea.line_set_move", text="", icon="TRIA_DOWN").direction = "DOWN"


def _draw_list(layout, owner, members, index, name, rows):
    """Draws a list with buttons for the operators `<name>_add` and `<name>_remove`; returns the column of buttons."""
    row = layout.row()
    row.template_list(f"FOVEA_UL_{name}s", "", owner, members, owner, index, rows=rows)
    side = row.column(align=True)
    side.operator(f"fovea.{name}_add", text="", icon="ADD")
    side.operator(f"fovea.{name}_remove", text="", icon="REMOVE")
    return side


def draw_filter(layout, line_set):
    """Draws the filters of a line set: by collection, object and material, each with a button to invert it; by the
    shape of surfaces, and by light."""
    column = layout.column()
    for name, others in FILTERS.items():
        chosen, known = getattr(line_set, name), KINDS[name]
        row = column.row(align=True)
        search = row.row(align=True)
        search.use_property_decorate = False
        search.alert = bool(chosen) and chosen not in getattr(bpy.data, known)
        search.prop_search(line_set, name, bpy.data, known)
        turn = row.row(align=True)
        turn.active = bool(chosen)
        turn.prop(line_set, others, text="", icon="ARROW_LEFTRIGHT")
    column.prop(line_set, "surfaces")
    column.prop(line_set, "light")


def is_for_all(line_set):
    return not any(getattr(line_set, name) for name in FILTERS)


def shapes_with(line_set, definition, asked):
    """The shapes of surfaces on which a line set draws a definition; `asked`: names of those of all line sets."""
    if line_set.surfaces not in {"ALL", "SUITED"}:
        return {line_set.surfaces}
    if line_set.surfaces == "SUITED" and definition["of_smooth"]:
        return {"SMOOTH"}
    replaced = line_set.surfaces == "SUITED" and definition["smooth_twin"] in asked
    return {"HARD", "ROUNDED"} if replaced else {"HARD", "ROUNDED", "SMOOTH"}


def taker(line_set, definition, before, asked):
    """The first of the line sets `before` that leaves a line set none of the lines of a definition; None without one.
    `asked` as for shapes_with."""
    wanted = set() if definition["in_image"] else shapes_with(line_set, definition, asked)
    has = (above for above in before if getattr(above.kinds, definition["name"]) and is_for_all(above))
    return next((above for above in has if wanted <= shapes_with(above, definition, asked)), None)


def draw_kinds(layout, held, line_set):
    """Draws the switches of all definitions, usual ones first and the others folded, and the parameters of those that
    are on."""
    before, asked = list(held.line_sets)[: held.line_set_index], style_data.drawn_kinds(held)
    usual = [definition for definition in definitions() if definition["usual"]]
    more = [definition for definition in definitions() if not definition["usual"]]
    if body := fold(layout, "line_types", "Line Types", closed=False):
        _draw_scopes(body, line_set, usual, before, asked)
    on = sum(getattr(line_set.kinds, definition["name"]) for definition in more)
    if body := fold(layout, "more_line_types", f"More Line Types ({on} on)" if on else "More Line Types"):
        _draw_scopes(body, line_set, more, before, asked)


def _draw_scopes(body, line_set, wanted, before, asked):
    for scope, title in SCOPES.items():
        group = [definition for definition in wanted if definition["scope"] == scope]
        if group:
            body.label(text=title)
        for definition in group:
            _draw_kind(body, line_set, definition, taker(line_set, definition, before, asked))


def _draw_kind(body, line_set, definition, taken):
    """Draws the switch of a definition and, if it is on, its parameters. `taken`: the line set that takes all its
    lines, or None."""
    name, kinds = definition["name"], line_set.kinds
    # Full width: most names are too long for half of it.
    switch = body.row()
    switch.use_property_split = False
    switch.prop(kinds, name)
    barred = definition["in_image"] and not is_for_all(line_set)
    switch.active = not (taken or barred)
    if taken:
        body.label(text=f"Taken by '{taken.name}' above", icon="INFO")
    elif barred:
        body.label(text="Needs a line set without filters", icon="INFO")
    if getattr(kinds, name):
        for parameter in definition["parameters"]:
            body.prop(kinds, f"{name}_{parameter['name']}")
        if definition["file"]:
            body.prop(kinds, f"{name}_{definition['file']['name']}")


def draw_pen_of_visible(layout, line_set):
    if body := fold(layout, "pen", "Pen", closed=False):
        draw_pen(body, line_set.pen)
        draw_properties(body, line_set, ("corner_angle", "least_length", "overshoot", "halo"))


def draw_other_pens(layout, scene, line_set):
    """Draws the pens out of focus and of hidden lines."""
    if body := fold_switch(layout, "pen_away", line_set, "away"):
        body.prop(line_set, "overshoot_away")
        draw_pen(body, line_set.pen_away)
    if body := fold(layout, "hidden", "Hidden Lines"):
        _draw_hidden(body, scene, line_set)


def _draw_hidden(body, scene, line_set):
    _draw_list(body, line_set, "hidden", "hidden_index", "hidden_pen", rows=2)
    hidden = edited_hidden(line_set)
    if hidden is None:
        return
    if scene.fovea.visibility == "SPINE":
        body.label(text="Per Pixel visibility draws visible lines only", icon="INFO")
    elif scene.fovea.visibility != "EXACT":
        body.label(text="Sampled visibility counts one surface at most", icon="INFO")
    draw_properties(body, hidden, ("first", "last"))
    draw_pen(body, hidden.pen)
    if away := fold_switch(body, "hidden_away", hidden, "away"):
        draw_pen(away, hidden.pen_away)
