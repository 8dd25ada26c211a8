# SPDX-License-Identifier: GPL-3.0-or-later
"""Random operations of artists in Blender, drawn from a random.Random, each one undo step; each returns whether it
could be done. In Edit mode only operations that edit the mesh, because Blender undoes nothing else there."""

import bpy

DO = ("EXEC_DEFAULT", True)
MOST_OBJECTS = 8


def done(operator, **words):
    return operator.poll() and "FINISHED" in operator(*DO, **words)


def told(what):
    """What was set by a script, as one step for undo."""
    bpy.ops.ed.undo_push(message=what)
    return True


def place(lot, size=2.5):
    return tuple(lot.uniform(-size, size) for _ in range(3))


def shapes():
    return [obj for obj in bpy.context.view_layer.objects if obj.type == "MESH" and obj.visible_get()]


def choose(lot):
    """Selects one object that is to be seen, alone; None where there is none."""
    for obj in bpy.context.view_layer.objects:
        obj.select_set(False)
    found = shapes()
    if not found:
        return None
    obj = lot.choice(found)
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    return obj


def add(lot):
    ops = bpy.ops.mesh
    kind = lot.choice((ops.primitive_cube_add, ops.primitive_cone_add, ops.primitive_monkey_add))
    few = len(bpy.context.scene.objects) < MOST_OBJECTS
    return few and done(kind, location=place(lot), rotation=place(lot))


def add_text(lot):
    few = len(bpy.context.scene.objects) < MOST_OBJECTS
    return few and done(bpy.ops.object.text_add, location=place(lot), radius=2)


def delete(lot):
    return len(shapes()) > 2 and choose(lot) and done(bpy.ops.object.delete)


def move(lot):
    return choose(lot) and done(bpy.ops.transform.translate, value=place(lot, 1))


def rotate(lot):
    return choose(lot) and done(bpy.ops.transform.rotate, value=lot.uniform(0.3, 3), orient_axis=lot.choice("XYZ"))


def resize(lot):
    return choose(lot) and done(bpy.ops.transform.resize, value=(1, lot.uniform(0.5, 1.5), 1))


def duplicate(lot):
    few = len(bpy.context.scene.objects) < MOST_OBJECTS
    moved = {"value": place(lot, 1.5)}
    return few and choose(lot) and done(bpy.ops.object.duplicate_move, TRANSFORM_OT_translate=moved)


def duplicate_linked(lot):
    few = len(bpy.context.scene.objects) < MOST_OBJECTS
    return few and choose(lot) and done(bpy.ops.object.duplicate_move_linked)


def join(lot):
    if len(shapes()) < 4 or not choose(lot):
        return False
    lot.choice(shapes()).select_set(True)
    return done(bpy.ops.object.join)


def parent(lot):
    if not choose(lot):
        return False
    lot.choice(shapes()).select_set(True)
    return done(bpy.ops.object.parent_set, type="OBJECT", keep_transform=True)


def hide(lot):
    return len(shapes()) > 2 and choose(lot) and done(bpy.ops.object.hide_view_set)


def unhide(_lot):
    return done(bpy.ops.object.hide_view_clear)


def smooth(lot):
    return choose(lot) and done(bpy.ops.object.shade_smooth)


def flat(lot):
    return choose(lot) and done(bpy.ops.object.shade_flat)


def subdivide_smoothly(lot):
    return choose(lot) and not bpy.context.object.modifiers and done(bpy.ops.object.modifier_add, type="SUBSURF")


def apply_modifier(lot):
    obj = choose(lot)
    one = obj and obj.modifiers and obj.data.users == 1
    return one and done(bpy.ops.object.modifier_apply, modifier=obj.modifiers[0].name)


def enter(lot):
    return choose(lot) and done(bpy.ops.object.mode_set, mode="EDIT")


def leave(_lot):
    return done(bpy.ops.object.mode_set, mode="OBJECT")


def select_all(_lot):
    return done(bpy.ops.mesh.select_all, action="SELECT")


def subdivide(_lot):
    return bpy.context.object.data.total_vert_sel < 300 and done(bpy.ops.mesh.subdivide)


def shove(lot):
    return done(bpy.ops.transform.translate, value=place(lot, 0.7))


def inset(lot):
    return done(bpy.ops.mesh.inset, thickness=lot.uniform(0.05, 0.2))


def mark(_lot):
    return done(bpy.ops.mesh.mark_freestyle_edge)


def add_slot(lot):
    return choose(lot) and done(bpy.ops.object.material_slot_add)


def remove_slot(lot):
    return choose(lot) and bpy.context.object.material_slots and done(bpy.ops.object.material_slot_remove)


def new_material(lot):
    obj = choose(lot)
    if not obj:
        return False
    material = bpy.data.materials.new("Coat")
    material.fovea.occlusion = lot.choice(("AUTOMATIC", "NEVER"))
    obj.data.materials.append(material)
    for polygon in obj.data.polygons:
        polygon.material_index = lot.randrange(len(obj.data.materials))
    return told("material")


WORKING = (
    *(add, add, add_text, delete, move, move, rotate, resize, duplicate, duplicate_linked, join, parent, hide, unhide),
    *(smooth, flat, subdivide_smoothly, apply_modifier, enter, enter, add_slot, remove_slot, new_material),
)
EDITING = (leave, leave, select_all, subdivide, shove, inset, mark)
