"""What materials mean for lines: which polygons share one, and which hide what lies behind them."""

from dataclasses import dataclass, field

SEE_THROUGH = {"BSDF_TRANSPARENT", "BSDF_GLASS", "BSDF_REFRACTION"}


@dataclass(frozen=True)
class Slot:
    """A material as a surface needs it."""

    name: str  # "" for an empty slot
    color: tuple = (0.8, 0.8, 0.8, 1.0)  # viewport display colour, scene-linear
    hides: bool = True
    holdout: bool = False
    lines: bool = field(default=True, compare=False)  # whether its faces have lines; the surface is the same without


def slots(obj, mesh, known):
    """The slots of an evaluated object's mesh, object-linked ones included. `known`: dict reused for one frame."""
    return tuple(_slot(material, known) for material in of(obj, mesh))


def of(obj, mesh):
    """The materials in the slots of an evaluated object's mesh, at least one slot; None for an empty one."""
    linked = {i: slot.material for i, slot in enumerate(obj.material_slots) if slot.link == "OBJECT"}
    return [linked.get(i, material) for i, material in enumerate(mesh.materials)] or [linked.get(0)]


def _slot(material, known):
    if material is None:
        return Slot("")
    name = material.name_full
    if name not in known:
        shader = surface_shader(material)
        choice = material.fovea.occlusion
        hides = choice == "ALWAYS" or (choice == "AUTOMATIC" and not _is_see_through(material, shader))
        holdout = shader is not None and shader.bl_idname == "ShaderNodeHoldout"
        known[name] = Slot(name, tuple(material.diffuse_color), hides, holdout, material.fovea.lines)
    return known[name]


def surface_shader(material):
    """The shader node at the material's surface output, or None."""
    # From Blender 5 on every material uses nodes, and the switch is going away.
    if material.node_tree is None or not getattr(material, "use_nodes", True):
        return None
    output = material.node_tree.get_output_node("ALL")
    return source(output.inputs["Surface"]) if output else None


def source(socket):
    """The node that feeds a socket, reroutes skipped, or None."""
    while socket.links:
        node = socket.links[0].from_node
        if node.type != "REROUTE":
            return node
        socket = node.inputs[0]
    return None


def _is_see_through(material, shader):
    """Whether one would see things through it: transparent, alpha-clipped, or glass."""
    if shader is None:
        return material.diffuse_color[3] < 1.0
    if shader.type in SEE_THROUGH:
        return True
    if shader.type == "BSDF_PRINCIPLED":
        alpha, transmission = shader.inputs["Alpha"], shader.inputs["Transmission Weight"]
        return bool(alpha.links) or alpha.default_value < 1.0 or transmission.default_value > 0.5
    if shader.type in {"MIX_SHADER", "ADD_SHADER"}:
        parts = (source(socket) for socket in shader.inputs if socket.type == "SHADER")
        return any(part is not None and _is_see_through(material, part) for part in parts)
    return False
