# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on the line sets of the scene's style, and on the hidden pens of the selected line set."""

import bpy
from bpy.props import EnumProperty, StringProperty

from .. import style
from ..scene import animation
from . import FILTERS, style_curves, style_data, style_read, style_write
from .style_operators import OnStyle

ISO_WIDTHS = "0.13", "0.18", "0.25", "0.35", "0.5", "0.7", "1.0", "1.4", "2.0"  # mm, of ISO 128
MOST = 64  # most line sets of a style
NEW = "Line Set"  # name of a new one: shipped styles have a set "lines"
_FOR_ALL = dict.fromkeys(FILTERS, "") | dict.fromkeys(FILTERS.values(), False)  # members of a LineSet without filters
DIRECTIONS = (("UP", "Up", "Draws its lines before"), ("DOWN", "Down", "Draws what is left after"))


def edited(held):
    """The selected line set in a style's properties, or None."""
    return held.line_sets[held.line_set_index] if held.line_set_index < len(held.line_sets) else None


def edited_hidden(line_set):
    """The selected hidden pen of a line set, or None."""
    return line_set.hidden[line_set.hidden_index] if line_set.hidden_index < len(line_set.hidden) else None


class _Edit(OnStyle):
    """Base of operators that edit the style's properties in `edit(held)`. Blender keeps what some of them do to a
    library override when the file is opened again."""

    kept_by_overrides = False

    @classmethod
    def hindrance_of(cls, tree):
        if tree.library:
            return "The style is linked from another file: duplicate it to edit it"
        if tree.override_library and not cls.kept_by_overrides:
            return "The style is a library override, which would lose this: duplicate it, or edit it in its own file"
        return cls.lacks(tree.fovea)

    @classmethod
    def lacks(cls, held):
        """Why the operator is unavailable for a style's properties, or None."""
        return None if edited(held) else "No line set is chosen"

    def act(self, context):
        self.edit(style_data.of(context.scene).fovea)
        context.scene.fovea.style.update_tag()


class FOVEA_OT_line_set_add(_Edit, bpy.types.Operator):
    """Add a line set above the edited one, with its line types and pens, for all objects and without hidden pens"""

    bl_idname, bl_label = "fovea.line_set_add", "Add Line Set"
    kept_by_overrides = True

    @classmethod
    def lacks(cls, held):
        return f"A style has at most {MOST} line sets" if len(held.line_sets) >= MOST else None

    def edit(self, held):
        source, place = edited(held), min(held.line_set_index, len(held.line_sets))
        like = style_read.line_set(source) if source else style.load("plain").line_sets[-1]
        _insert(held, like.replace(name=_free_name(held, NEW), hidden=(), **_FOR_ALL), place)


class FOVEA_OT_line_set_duplicate(_Edit, bpy.types.Operator):
    """Add a copy of the edited line set below it, filters and hidden pens included: it draws what that one leaves"""

    bl_idname, bl_label = "fovea.line_set_duplicate", "Duplicate Line Set"

    @classmethod
    def lacks(cls, held):
        return FOVEA_OT_line_set_add.lacks(held) or super().lacks(held)

    def edit(self, held):
        source = edited(held)
        kept, place = source.kept, held.line_set_index + 1
        _insert(held, style_read.line_set(source).replace(name=_free_name(held, source.name)), place)
        held.line_sets[place].kept = kept


class FOVEA_OT_line_set_remove(_Edit, bpy.types.Operator):
    """Remove the line set that is edited"""

    bl_idname, bl_label = "fovea.line_set_remove", "Remove Line Set"

    @classmethod
    def lacks(cls, held):
        return super().lacks(held) or ("A style needs a line set" if len(held.line_sets) < 2 else None)

    def edit(self, held):
        count, gone = len(held.line_sets), held.line_set_index
        held.line_sets.remove(gone)
        style_curves.drop_unused(held.id_data)
        animation.follow(held.id_data, [None if i == gone else i - (i > gone) for i in range(count)])
        held.line_set_index = min(held.line_set_index, len(held.line_sets) - 1)


class FOVEA_OT_line_set_move(_Edit, bpy.types.Operator):
    """Move the line set that is edited: a line goes to the first set that has its kind"""

    bl_idname, bl_label = "fovea.line_set_move", "Move Line Set"

    direction: EnumProperty(name="Direction", description="Before or after its neighbor", items=DIRECTIONS)

    def edit(self, held):
        to = held.line_set_index + (-1 if self.direction == "UP" else 1)
        if 0 <= to < len(held.line_sets):
            move(held, held.line_set_index, to)
            held.line_set_index = to


class FOVEA_OT_hidden_pen_add(_Edit, bpy.types.Operator):
    """Draw lines of the set that surfaces hide, with a pen of their own and below the visible ones"""

    bl_idname, bl_label = "fovea.hidden_pen_add", "Add Hidden Pen"
    kept_by_overrides = True

    def edit(self, held):
        line_set = edited(held)
        dashes = style.dashed(style_read.pen(line_set.pen))
        ends = [hidden.last or hidden.first for hidden in line_set.hidden]
        first = min(max(ends, default=0) + 1, style.MOST_SURFACES)
        for hidden in line_set.hidden:
            hidden.last = hidden.last or hidden.first  # close unlimited ranges, so that the new one can follow
        style_write.write_hidden(line_set.hidden.add(), style.Hidden(pen=dashes, first=first))
        line_set.hidden_index = len(line_set.hidden) - 1


class FOVEA_OT_hidden_pen_remove(_Edit, bpy.types.Operator):
    """Draw no longer what so many surfaces hide"""

    bl_idname, bl_label = "fovea.hidden_pen_remove", "Remove Hidden Pen"

    @classmethod
    def lacks(cls, held):
        return super().lacks(held) or (None if edited_hidden(edited(held)) else "The line set has no hidden pen")

    def edit(self, held):
        line_set = edited(held)
        line_set.hidden.remove(line_set.hidden_index)
        style_curves.drop_unused(held.id_data)
        line_set.hidden_index = max(min(line_set.hidden_index, len(line_set.hidden) - 1), 0)


class FOVEA_OT_pen_width(_Edit, bpy.types.Operator):
    """Make the strokes of the pen as wide as technical pens are, in millimeters on the page"""

    bl_idname, bl_label = "fovea.pen_width", "Width of Technical Pens"

    pen: StringProperty(
        name="Pen", description="Path of the pen's properties in the style; none: that of the chosen line set"
    )
    width: EnumProperty(
        name="Width",
        description="Of the pen, by ISO 128",
        items=[(width, f"{width} mm", "") for width in ISO_WIDTHS],
        default="0.35",
    )

    def edit(self, held):
        pen = held.id_data.path_resolve(self.pen) if self.pen else edited(held).pen
        pen.width_unit, pen.width = "MILLIMETRES", float(self.width)


class FOVEA_OT_pen_curve_add(_Edit, bpy.types.Operator):
    """Say by a curve how strokes of the pen change along their length"""

    bl_idname, bl_label = "fovea.pen_curve_add", "Add Curve"

    pen: StringProperty(name="Pen", description="Path of the pen's properties in the style")
    effect: StringProperty(name="Effect", description="Which of the pen's effects the curve is of")

    def edit(self, held):
        style_curves.add_to_pen(held.id_data.path_resolve(self.pen), self.effect)


def move(held, source, to):
    """Moves a line set to another index, together with its F-curves and drivers."""
    order = list(range(len(held.line_sets)))
    order.insert(to, order.pop(source))
    held.line_sets.move(source, to)
    animation.follow(held.id_data, [order.index(i) for i in range(len(order))])


def _insert(held, wanted, place):
    """Inserts a LineSet at an index and selects it."""
    style_write.write_line_set(held.line_sets.add(), wanted)
    move(held, len(held.line_sets) - 1, place)
    held.line_set_index = place


def _free_name(held, wanted):
    """The name, or one with a number, that no line set has, whether in capitals or not."""
    taken, stem = {line_set.name.lower() for line_set in held.line_sets}, wanted.rpartition(".")[0] or wanted
    names = (wanted, *(f"{stem}.{number:03}" for number in range(1, MOST + 2)))
    return next(name for name in names if name.lower() not in taken)
