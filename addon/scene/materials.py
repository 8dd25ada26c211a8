# SPDX-License-Identifier: GPL-3.0-or-later
"""Material slots as far as lines depend on them: identity, color, and whether they occlude."""

from dataclasses import dataclass, field

from . import see_through, shader_links


@dataclass(frozen=True)
class Slot:
    """The properties of a material slot that a surface needs."""

    name: str  # "" for an empty slot
    color: tuple = (0.8, 0.8, 0.8, 1.0)  # viewport display color, scene-linear
    hides: bool = True  # occludes
    holdout: bool = False
    lines: bool = field(default=True, compare=False)  # whether its faces have lines; does not affect the surface
    remark: str = field(default="", compare=False)  # phrase on whether it occludes and why, if that is not obvious


def slots(obj, mesh, known):
    """The Slots of an evaluated object's mesh, including object-linked ones. `known`: {name: Slot} cache for a
    frame."""
    return tuple(_slot(material, known) for material in of(obj, mesh))


def of(obj, mesh):
    """The materials in the slots of an evaluated object's mesh, None for an empty slot; at least one entry."""
    linked = {i: slot.material for i, slot in enumerate(obj.material_slots) if slot.link == "OBJECT"}
    return [linked.get(i, material) for i, material in enumerate(mesh.materials)] or [linked.get(0)]


def _slot(material, known):
    if material is None:
        return Slot("")
    name = material.name_full
    if name not in known:
        shader = shader_links.surface_shader(material)
        holdout = shader is not None and shader.bl_idname == "ShaderNodeHoldout"
        hides, remark = _hides(material)
        known[name] = Slot(name, tuple(material.diffuse_color), hides, holdout, material.fovea.lines, remark)
    return known[name]


def _hides(material):
    """(whether a material occludes, the Slot's remark)."""
    choice, found = material.fovea.occlusion, see_through.through(material)
    hides = choice == "ALWAYS" or (choice == "AUTOMATIC" and not found.is_enough)
    what = "hides what lies behind it as a whole" if hides else "hides nothing"
    if hides == found.is_enough:
        return hides, f"{what}, as Hides Lines in the material's Line Drawing panel says"
    if found.most > 0.0:
        why = " and ".join(found.why)
        return hides, f"{what}, since {why}; Hides Lines in the material's Line Drawing panel changes it"
    return hides, ""
