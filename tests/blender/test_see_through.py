# SPDX-License-Identifier: GPL-3.0-or-later
"""Which materials occlude, depending on their nodes, and what the report says about it."""

import bpy
import pytest
from the_addon import box_mesh, empty_scene, new_object, part

see_through, report = part("scene.see_through"), part("render.report")
TRANSPARENT, GLASS = "it has a Transparent BSDF", "it is glass"
FACTOR = "its mix factor is {}"
HIDES, SHOWS = True, False


@pytest.fixture(autouse=True)
def scene():
    return empty_scene()


class Nodes:
    """The node tree of a material or a group, to be built in a line or two."""

    def __init__(self, tree):
        self.tree = tree

    def add(self, kind, *links, **values):
        """A node whose first inputs are fed by sockets (None: not), others set by name; its first output, if any."""
        node = self.tree.nodes.new(f"ShaderNode{kind}")
        for name, value in values.items():
            node.inputs[name.replace("_", " ")].default_value = value
        for socket, target in zip(links, node.inputs):
            if socket is not None:
                self.tree.links.new(socket, target)
        return node.outputs[0] if node.outputs else None

    def principled(self, *, linked=(), **values):
        shader = self.add("BsdfPrincipled", **values)
        for name in linked:
            self.tree.links.new(self.add("TexNoise"), shader.node.inputs[name])
        return shader

    def mix(self, factor, first, second):
        """`factor`: a number, or a socket."""
        mixed = self.add("MixShader", None, first, second)
        if isinstance(factor, bpy.types.NodeSocket):
            self.tree.links.new(factor, mixed.node.inputs[0])
        else:
            mixed.node.inputs[0].default_value = factor
        return mixed

    def clear(self):
        return self.add("BsdfTransparent")

    def diffuse(self):
        return self.add("BsdfDiffuse")

    def reroute(self, socket):
        node = self.tree.nodes.new("NodeReroute")
        self.tree.links.new(socket, node.inputs[0])
        return node.outputs[0]

    def value(self, number):
        socket = self.add("Value")
        socket.default_value = number
        return socket

    def light_path(self, output):
        return self.add("LightPath").node.outputs[output]

    def group(self, build, shader=None, **inputs):
        """The shader of a new node group. `build(inside, given)` makes it; `given` are the sockets inside of the
        shader and the values that the group is given from without."""
        tree = bpy.data.node_groups.new("Group", "ShaderNodeTree")
        tree.interface.new_socket("Other", in_out="OUTPUT", socket_type="NodeSocketFloat")
        tree.interface.new_socket("Shader", in_out="OUTPUT", socket_type="NodeSocketShader")
        tree.interface.new_socket("Shader", in_out="INPUT", socket_type="NodeSocketShader")
        for name in inputs:
            tree.interface.new_socket(name, in_out="INPUT", socket_type="NodeSocketFloat")
        given = tree.nodes.new("NodeGroupInput").outputs
        tree.links.new(build(Nodes(tree), given), tree.nodes.new("NodeGroupOutput").inputs["Shader"])
        node = self.tree.nodes.new("ShaderNodeGroup")
        node.node_tree = tree
        if shader is not None:
            self.tree.links.new(shader, node.inputs["Shader"])
        for name, value in inputs.items():
            node.inputs[name].default_value = value
        return node.outputs["Shader"]


def material(build, name="Material"):
    """A material whose surface is the shader that `build` makes of Nodes."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    made.node_tree.nodes.clear()
    nodes = Nodes(made.node_tree)
    nodes.add("OutputMaterial", build(nodes))
    return made


def given_to_a_group(factor):
    """Builds a group that mixes the shader it is given with a transparent one."""

    def mixed(inside, given):
        return inside.mix(given["Factor"], given["Shader"], inside.clear())

    return lambda nodes: nodes.group(mixed, nodes.diffuse(), Factor=factor)


CASES = {
    "plain": (lambda n: n.principled(), HIDES, []),
    "alpha below one half": (lambda n: n.principled(Alpha=0.4), SHOWS, ["its alpha is 0.4"]),
    "alpha of one half": (lambda n: n.principled(Alpha=0.5), HIDES, ["its alpha is 0.5"]),
    "linked alpha": (lambda n: n.principled(linked=["Alpha"]), HIDES, ["its alpha is linked"]),
    "linked color": (lambda n: n.principled(linked=["Base Color"]), HIDES, []),
    "much transmission": (lambda n: n.principled(Transmission_Weight=0.6), SHOWS, ["its transmission is 0.6"]),
    "little transmission": (lambda n: n.principled(Transmission_Weight=0.4), HIDES, ["its transmission is 0.4"]),
    "linked transmission": (
        lambda n: n.principled(linked=["Transmission Weight"]),
        *(HIDES, ["its transmission is linked"]),
    ),
    "linked transmission of what has little alpha": (
        lambda n: n.principled(linked=["Transmission Weight"], Alpha=0.3),
        *(SHOWS, ["its alpha is 0.3", "its transmission is linked"]),
    ),
    "linked alpha of what has much transmission": (
        lambda n: n.principled(linked=["Alpha"], Transmission_Weight=0.7),
        *(HIDES, ["its alpha is linked", "its transmission is 0.7"]),
    ),
    "transparent": (lambda n: n.clear(), SHOWS, [TRANSPARENT]),
    "glass": (lambda n: n.add("BsdfGlass"), SHOWS, [GLASS]),
    "refraction": (lambda n: n.add("BsdfRefraction"), SHOWS, [GLASS]),
    "emission": (lambda n: n.add("Emission"), HIDES, []),
    "behind reroutes": (lambda n: n.reroute(n.reroute(n.clear())), SHOWS, [TRANSPARENT]),
    "mostly transparent": (lambda n: n.mix(0.6, n.diffuse(), n.clear()), SHOWS, [TRANSPARENT, FACTOR.format("0.6")]),
    "half transparent": (lambda n: n.mix(0.5, n.diffuse(), n.clear()), HIDES, [TRANSPARENT, FACTOR.format("0.5")]),
    "transparent first": (lambda n: n.mix(0.4, n.clear(), n.diffuse()), SHOWS, [TRANSPARENT, FACTOR.format("0.4")]),
    "none of the transparent": (lambda n: n.mix(0.0, n.diffuse(), n.clear()), HIDES, []),
    "all of the transparent": (lambda n: n.mix(1.0, n.diffuse(), n.clear()), SHOWS, [TRANSPARENT]),
    "mix with nothing": (lambda n: n.mix(0.9, n.clear(), None), HIDES, [TRANSPARENT, FACTOR.format("0.9")]),
    "factor of a value node": (
        lambda n: n.mix(n.value(0.9), n.diffuse(), n.clear()),
        *(SHOWS, [TRANSPARENT, FACTOR.format("0.9")]),
    ),
    "linked factor": (
        lambda n: n.mix(n.add("TexNoise"), n.diffuse(), n.clear()),
        *(HIDES, [TRANSPARENT, FACTOR.format("linked")]),
    ),
    "linked factor of two that hide": (lambda n: n.mix(n.add("TexNoise"), n.diffuse(), n.diffuse()), HIDES, []),
    "linked factor of two that are see-through": (
        lambda n: n.mix(n.add("TexNoise"), n.clear(), n.add("BsdfGlass")),
        *(SHOWS, [TRANSPARENT, GLASS]),
    ),
    "pane of transparent and glossy": (
        lambda n: n.mix(n.add("Fresnel"), n.clear(), n.add("BsdfGlossy")),
        *(SHOWS, [TRANSPARENT]),
    ),
    "transparent to shadow rays": (
        lambda n: n.mix(n.light_path("Is Shadow Ray"), n.diffuse(), n.clear()),
        *(HIDES, []),
    ),
    "transparent to camera rays": (
        lambda n: n.mix(n.light_path("Is Camera Ray"), n.diffuse(), n.clear()),
        *(SHOWS, [TRANSPARENT]),
    ),
    "mix in a mix": (
        lambda n: n.mix(0.2, n.mix(0.2, n.clear(), n.diffuse()), n.diffuse()),
        *(SHOWS, [TRANSPARENT, FACTOR.format("0.2")]),
    ),
    "glow": (lambda n: n.add("AddShader", n.clear(), n.add("Emission")), SHOWS, [TRANSPARENT]),
    "sum of clear shaders": (lambda n: n.add("AddShader", n.clear(), n.add("BsdfGlass")), SHOWS, [TRANSPARENT, GLASS]),
    "sum with nothing": (lambda n: n.add("AddShader", n.clear(), None), SHOWS, [TRANSPARENT]),
    "surface lit through": (lambda n: n.add("AddShader", n.clear(), n.principled()), HIDES, []),
    "leaf lit through": (
        lambda n: n.add("AddShader", n.clear(), n.principled(linked=["Alpha"])),
        *(HIDES, [TRANSPARENT, "its alpha is linked"]),
    ),
    "transparent in a group": (lambda n: n.group(lambda inside, given: inside.clear()), SHOWS, [TRANSPARENT]),
    "linked alpha in a group": (
        lambda n: n.group(lambda inside, given: inside.principled(linked=["Alpha"])),
        *(HIDES, ["its alpha is linked"]),
    ),
    "high factor given to a group": (given_to_a_group(0.8), SHOWS, [TRANSPARENT, FACTOR.format("0.8")]),
    "low factor given to a group": (given_to_a_group(0.2), HIDES, [TRANSPARENT, FACTOR.format("0.2")]),
}


@pytest.mark.parametrize("build, hides, why", CASES.values(), ids=CASES.keys())
def test_a_material_hides_as_a_whole_unless_it_is_see_through_as_a_whole(build, hides, why):
    found = see_through.through(material(build))
    assert (not found.is_enough) == hides
    assert list(found.why) == why


@pytest.mark.parametrize("alpha, hides", [(0.4, SHOWS), (0.6, HIDES)])
def test_a_material_without_a_shader_hides_by_the_alpha_of_its_viewport_color(alpha, hides):
    plain = bpy.data.materials.new("Plain")
    if plain.node_tree:
        plain.node_tree.nodes.clear()
    plain.diffuse_color[3] = alpha
    found = see_through.through(plain)
    assert (not found.is_enough) == hides
    assert found.why == (f"the alpha of its viewport color is {alpha}",)


@pytest.mark.parametrize("targets", [("EEVEE", "CYCLES"), ("CYCLES",), ("ALL", "EEVEE")])
def test_outputs_for_single_engines_count_where_there_is_none_for_all(targets):
    made = bpy.data.materials.new("Engines")
    made.use_nodes = True
    made.node_tree.nodes.clear()
    made.diffuse_color[3] = 0.1  # see-through, if no output is found
    nodes = Nodes(made.node_tree)
    for i, target in enumerate(targets):
        output = made.node_tree.nodes.new("ShaderNodeOutputMaterial")
        output.target = target
        made.node_tree.links.new(nodes.clear() if i else nodes.diffuse(), output.inputs["Surface"])
    assert not see_through.through(made).is_enough


def test_a_volume_without_a_surface_hides_nothing():
    smoke = material(lambda nodes: None, "Smoke")
    output = next(node for node in smoke.node_tree.nodes if node.type == "OUTPUT_MATERIAL")
    smoke.node_tree.links.new(Nodes(smoke.node_tree).add("VolumeScatter"), output.inputs["Volume"])
    assert see_through.through(smoke).is_enough


def test_the_report_says_which_materials_hide_nothing_and_which_hide_although_they_have_transparency_and_why():
    made = [
        material(lambda nodes: nodes.principled(linked=["Alpha"]), "Leaf"),
        material(lambda nodes: nodes.add("BsdfGlass"), "Pane"),
        material(lambda nodes: nodes.diffuse(), "Wall"),
        material(lambda nodes: nodes.diffuse(), "Ghost"),
        material(lambda nodes: nodes.principled(linked=["Alpha"]), "Hair"),
    ]
    made[3].fovea.occlusion, made[4].fovea.occlusion = "NEVER", "ALWAYS"
    mesh = box_mesh()
    for one in made:
        mesh.materials.append(one)
    new_object(mesh)
    bpy.ops.fovea.report()
    lines = [line.strip() for line in bpy.data.texts[report.TEXT].as_string().splitlines()]
    first = lines.index("Transparency") + 1
    panel = "Hides Lines in the material's Line Drawing panel"
    noise = "it comes from a node that is not followed, Noise Texture"
    assert lines[first : first + 4] == [
        f"'Ghost' hides nothing, as {panel} says",
        f"'Hair' hides what lies behind it as a whole, since where its alpha is opaque cannot be told: {noise}; "
        f"{panel} changes it",
        f"'Leaf' hides what lies behind it as a whole, since where its alpha is opaque cannot be told: {noise}; "
        f"{panel} changes it",
        f"'Pane' hides nothing, since it is glass; {panel} changes it",
    ]
    assert not any("'Wall'" in line for line in lines)


def test_there_is_nothing_to_say_of_transparency_where_there_is_none():
    new_object(box_mesh())
    bpy.ops.fovea.report()
    assert "Transparency" not in bpy.data.texts[report.TEXT].as_string()
