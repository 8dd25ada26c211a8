# SPDX-License-Identifier: GPL-3.0-or-later
"""Random operations of artists with the add-on: see operations.py."""

import bpy
from operations import choose, done, place, told
from the_addon import part

style_data = part("style.style_data")


def object_property(lot):
    obj = choose(lot)
    if not obj:
        return False
    settings = obj.fovea
    name, values = lot.choice(
        (("usage", ("BOTH", "OCCLUDE", "DRAW", "IGNORE")), ("priority", (0, 1)), ("refine", (False, True)))
    )
    setattr(settings, name, lot.choice(values))
    return told(name)


def new_style(lot):
    return done(bpy.ops.fovea.style_new, style=lot.choice(("plain", "technical", "charcoal")))


def apply_style(lot):
    return done(bpy.ops.fovea.style_apply, style=lot.choice(("pencil", "xray_focus", "study")))


def duplicate_style(_lot):
    return done(bpy.ops.fovea.style_duplicate)


def line_set(lot):
    return done(lot.choice((bpy.ops.fovea.line_set_add, bpy.ops.fovea.line_set_duplicate)))


def remove_line_set(_lot):
    return done(bpy.ops.fovea.line_set_remove)


def move_line_set(lot):
    return done(bpy.ops.fovea.line_set_move, direction=lot.choice(("UP", "DOWN")))


def hidden_pen(lot):
    return done(lot.choice((bpy.ops.fovea.hidden_pen_add, bpy.ops.fovea.hidden_pen_remove)))


def pick_focus(lot):
    return done(bpy.ops.fovea.pick_focus, location=place(lot))


def focus_pull(lot):
    return done(bpy.ops.fovea.focus_pull, target="LOCATION", location=place(lot), frame_start=1, frame_end=20)


def setting(lot):
    """A number of the style, or of where to look."""
    tree = style_data.of(bpy.context.scene)
    if tree is None:
        return False
    held, scene = tree.fovea, bpy.context.scene.fovea
    chosen = lot.choice(held.line_sets)
    owner, name, value = lot.choice(
        (
            (chosen.pen, "width", lot.uniform(0.5, 6)),
            (chosen.pen, "color", place(lot, 1)),
            (chosen, "overshoot", lot.uniform(0, 20)),
            (chosen.kinds, "crease", not chosen.kinds.crease),
            (chosen.kinds, "suggestive_contour", not chosen.kinds.suggestive_contour),
            (held.paper, "color", tuple(lot.uniform(0.6, 1) for _ in range(3))),
            (held.elision, "enabled", not held.elision.enabled),
            (scene, "focus_model", lot.choice(("NONE", "IMAGE", "SCENE"))),
            (scene, "mix", lot.random()),
            (scene, "mixed_style", tree),
        )
    )
    setattr(owner, name, value)
    return told(name)


WORKING = (
    *(object_property, object_property, new_style, apply_style, duplicate_style, line_set, remove_line_set),
    *(move_line_set, hidden_pen, pick_focus, focus_pull, setting, setting, setting),
)
