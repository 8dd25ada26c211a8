# SPDX-License-Identifier: GPL-3.0-or-later
"""Render > Fovea > Learn Lines from Drawing: a model of where an artist draws, and the scene's lines by it."""

from functools import cache

import bpy

from .. import catalogue, comparison, files, learned_lines, style
from ..scene import camera
from ..scene.line_kinds import property_name
from ..scene.problem import CannotDraw
from ..style import style_data
from . import local_properties
from .compare_operators import OfDrawing

SUFFIX = ".lines.json"  # of the model of a drawing


def _kinds(_self, _context):
    return _items()


@cache  # Blender keeps no copies of the texts
def _items():
    return [(name.upper(), label, told) for name, label, told in learned_lines.kinds()]


class FOVEA_OT_learn_lines(OfDrawing, bpy.types.Operator):
    """Learn from a drawing of this frame, or several, where artists draw lines, write that to a file beside the first,
    and draw such lines by the pen of the line set that is edited"""

    bl_idname, bl_label = "fovea.learn_lines", "Learn Lines from Drawing"
    shown = (*OfDrawing.shown, "kind", "alone")

    kind: bpy.props.EnumProperty(name="Model", description="What is made of the drawing", items=_kinds, default=1)
    alone: bpy.props.BoolProperty(
        name="Alone", description="Switch all other lines of the style off: a model draws outlines, too", default=True
    )

    def act(self, context):
        drawings, by, tolerance = self.asked()
        line_set = _edited(context.scene)
        path = self.paths[0].with_suffix(SUFFIX)
        size = comparison.frame_for(drawings, camera.frame_size(context.scene.render), by)
        tolerance = comparison.tolerance_in(drawings, size, by, tolerance)
        judges_of = comparison.judges_of(drawings, size, by, tolerance)
        properties, judges, outlines = local_properties.with_judges(context, size, None, judges_of)
        made = learned_lines.learn(properties, judges, self.kind.lower(), tolerance, outlines)
        with files.written(path) as fresh:
            fresh.write_text(made.model.json(), encoding="utf-8")
        line_set = line_set or _edited(context.scene, own=True)
        _draw_by(path, line_set, style_data.own(context.scene).line_sets if self.alone else ())
        self.report(
            {"INFO"},
            f"The line set '{line_set.name}' has lines by {path}, with F1 {made.found['f1']:.2f} where the drawing was "
            "held out",
        )


def _draw_by(path, line_set, alone_of):
    """Switches the definition on that is given a model, with this one; and all else off of the line sets `alone_of`."""
    for other in alone_of:
        for definition in catalogue.definitions():
            setattr(other.kinds, definition["name"], False)
    learned = next(definition for definition in catalogue.definitions() if definition["file"])
    setattr(line_set.kinds, learned["name"], True)
    setattr(line_set.kinds, property_name(learned, learned["file"]), str(path))


def _edited(scene, own=False):
    """The line set that is edited, of a style that is made if `own`; None if there is no style. CannotDraw if it has
    filters."""
    if not own and style_data.of(scene) is None:
        return None
    held = style_data.own(scene)
    line_set = held.line_sets[held.line_set_index]
    if any(getattr(line_set, name) for name in style.FILTERS):
        raise CannotDraw(
            f"The line set '{line_set.name}' has filters, and learned lines need one without: edit another"
        )
    return line_set
