# SPDX-License-Identifier: GPL-3.0-or-later
"""Material slots as far as lines depend on them: identity, color, and whether they occlude."""

from dataclasses import dataclass, field

from . import see_through, shader_links

PANEL = "Hides Lines in the material's Line Drawing panel"


@dataclass(frozen=True)
class Slot:
    """The properties of a material slot that a surface needs."""

    name: str  # "" for an empty slot
    color: tuple = (0.8, 0.8, 0.8, 1.0)  # viewport display color, scene-linear
    hides: bool = True  # occludes
    holdout: bool = False
    one_sided: bool = False  # its backs are culled
    cut: object | None = None  # opacity_nodes.Source: it exists only where that is opaque
    lines: bool = field(default=True, compare=False)  # whether its faces have lines; does not affect the surface
    unknown: str = field(default="", compare=False)  # phrase on why it cannot be told where its alpha is opaque
    remark: str = field(default="", compare=False)  # phrase on whether it occludes and why, if that is not obvious


EMPTY = Slot("")


def slots(obj, mesh, known):
    """The Slots of an evaluated object's mesh, including object-linked ones. `known`: {name: Slot} cache for a
    frame."""
    return slots_of(of(obj, mesh), known)


def slots_of(found, known):
    """The Slots of materials, or None for an empty slot."""
    return tuple(_slot(material, known) for material in found)


def of(obj, mesh):
    """The materials in the slots of an evaluated object's mesh, None for an empty slot; at least one entry."""
    linked = {i: slot.material for i, slot in enumerate(obj.material_slots) if slot.link == "OBJECT"}
    return [linked.get(i, material) for i, material in enumerate(mesh.materials)] or [linked.get(0)]


def opacity(material):
    """How much of its own color a material has that hides nothing, before what lies behind it; 0 of one that hides
    nothing only because Hides Lines says so."""
    if material is None or _hides(material)[0]:
        return 0.0
    found = see_through.through(material)
    return 1.0 - found.least if found.is_enough else 0.0


def _slot(material, known):
    if material is None:
        return EMPTY
    name = material.name_full
    if name not in known:
        shader = shader_links.surface_shader(material)
        holdout = shader is not None and shader.bl_idname == "ShaderNodeHoldout"
        hides, cut, unknown, remark = _hides(material)
        color, one_sided = tuple(material.diffuse_color), material.use_backface_culling
        known[name] = Slot(name, color, hides, holdout, one_sided, cut, material.fovea.lines, unknown, remark)
    return known[name]


def _hides(material):
    """(whether a material occludes, the Slot's cut, unknown and remark)."""
    choice, found = material.fovea.occlusion, see_through.through(material)
    hides = choice == "ALWAYS" or (choice == "AUTOMATIC" and not found.is_enough)
    if found.cut and choice != "ALWAYS":
        nothing = "" if hides else f", and hides nothing, as {PANEL} says"
        return hides, found.cut, "", f"is cut out where its image '{found.cut.image}' is transparent{nothing}"
    what = "hides what lies behind it as a whole" if hides else "hides nothing"
    if hides == found.is_enough or (found.cut and hides):
        return hides, None, "", f"{what}, as {PANEL} says"
    if found.most > 0.0:
        why = f"where its alpha is opaque cannot be told: {found.unknown}" if found.unknown else " and ".join(found.why)
        return hides, None, found.unknown, f"{what}, since {why}; {PANEL} changes it"
    return hides, None, "", ""
