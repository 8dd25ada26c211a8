# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials are cut out where the image of their alpha is transparent, and backs that they cull are not there: in
lines, in what hides them, and in colors."""

import math

import bpy
import numpy as np
import pytest
from native_frames import core, frame_of, moved, scene_of, view_of
from pictures import SIZE, box_scene, layered
from test_see_through import Nodes
from the_addon import add_camera, empty_scene, new_mesh, new_object, part

api, reading, style = part("scene.api"), part("render.reading"), part("style")
see_through, opacity_nodes, session = part("scene.see_through"), part("scene.opacity_nodes"), part("render.session")
RADIUS, TEXELS = 0.3, 64
TEXEL = 2 / TEXELS  # on the card


def disc(name="Disc"):
    """An image whose alpha is a disc of RADIUS in its middle, with an edge of a texel."""
    made = bpy.data.images.new(name, TEXELS, TEXELS, alpha=True)
    at = (np.arange(TEXELS) + 0.5) / TEXELS - 0.5
    inside = np.clip(0.5 + TEXELS * (RADIUS - np.hypot(*np.meshgrid(at, at))), 0, 1)
    made.pixels.foreach_set(np.dstack([np.full((TEXELS, TEXELS, 3), 0.5), inside]).astype(np.float32).ravel())
    return made


def leaf(build=None, name="Leaf", image=None):
    """A material whose alpha is that of an image, or build(nodes, image node)."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    made.node_tree.nodes.clear()
    nodes = Nodes(made.node_tree)
    texture = made.node_tree.nodes.new("ShaderNodeTexImage")
    texture.image = image or disc()
    if build is None:
        shader = nodes.principled(Base_Color=(0, 1, 0, 1))
        made.node_tree.links.new(texture.outputs["Alpha"], shader.node.inputs["Alpha"])
    else:
        shader = build(nodes, texture)
    nodes.add("OutputMaterial", shader)
    return made


def card(material, name="Card", half=1.0, location=(0, 0, 0)):
    """A square that faces up, with the whole image."""
    mesh = new_mesh([(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)], [], [(0, 1, 2, 3)], name)
    mesh.uv_layers.new(name="Map").data.foreach_set("uv", np.array([0, 0, 1, 0, 1, 1, 0, 1], np.float32))
    mesh.materials.append(material)
    return new_object(mesh, name, location)


@pytest.fixture
def above():
    """A camera that looks down from 5 above the origin at 4 units."""
    scene = empty_scene()
    camera = add_camera((0, 0, 5), (0, 0, 0))
    camera.rotation_euler = (0, 0, 0)
    camera.data.type, camera.data.ortho_scale = "ORTHO", 4.0
    scene.render.resolution_x = scene.render.resolution_y = 400
    return scene


def length(found):
    return sum(np.linalg.norm(np.diff(points, axis=0), axis=1).sum() for points in polylines(found))


def polylines(found):
    return np.split(found["points"], found["offsets"][1:-1])


def read(scene):
    return reading.Reader().read(bpy.context.evaluated_depsgraph_get(), style.load(style.DEFAULT))


def math_node(nodes, operation, *links, **values):
    node = nodes.tree.nodes.new("ShaderNodeMath")
    node.operation = operation
    for i, given in enumerate(links):
        if isinstance(given, float):
            node.inputs[i].default_value = given
        else:
            nodes.tree.links.new(given, node.inputs[i])
    return node.outputs[0]


def by_alpha(socket_of):
    """Builds a Principled BSDF whose alpha is socket_of(nodes, image node)."""

    def build(nodes, texture):
        shader = nodes.principled()
        nodes.tree.links.new(socket_of(nodes, texture), shader.node.inputs["Alpha"])
        return shader

    return build


def ramp(nodes, texture, *stops):
    node = nodes.tree.nodes.new("ShaderNodeValToRGB")
    for element, (place, value) in zip(node.color_ramp.elements, stops, strict=True):
        element.position, element.color = place, (value, value, value, 1)
    nodes.tree.links.new(texture.outputs["Alpha"], node.inputs[0])
    return node.outputs[0]


def channel(nodes, texture, name):
    node = nodes.tree.nodes.new("ShaderNodeSeparateColor")
    nodes.tree.links.new(texture.outputs["Color"], node.inputs[0])
    return node.outputs[name]


# name: (what a material is made of, the channel, the value at which it turns opaque, whether it is opaque above it)
FOLLOWED = {
    "alpha": (by_alpha(lambda n, t: t.outputs["Alpha"]), "ALPHA", 0.5, True),
    "color": (by_alpha(lambda n, t: t.outputs["Color"]), "GRAY", 0.5, True),
    "a channel": (by_alpha(lambda n, t: channel(n, t, "Green")), "GREEN", 0.5, True),
    "greater than": (
        by_alpha(lambda n, t: math_node(n, "GREATER_THAN", t.outputs["Alpha"], 0.2)),
        *("ALPHA", 0.2, True),
    ),
    "less than": (by_alpha(lambda n, t: math_node(n, "LESS_THAN", t.outputs["Alpha"], 0.2)), "ALPHA", 0.2, False),
    "a number less than": (
        by_alpha(lambda n, t: math_node(n, "LESS_THAN", 0.3, t.outputs["Alpha"])),
        *("ALPHA", 0.3, True),
    ),
    "one minus": (by_alpha(lambda n, t: math_node(n, "SUBTRACT", 1.0, t.outputs["Alpha"])), "ALPHA", 0.5, False),
    "twice": (by_alpha(lambda n, t: math_node(n, "MULTIPLY", t.outputs["Alpha"], 2.0)), "ALPHA", 0.25, True),
    "rising ramp": (by_alpha(lambda n, t: ramp(n, t, (0.2, 0.0), (0.4, 1.0))), "ALPHA", 0.3, True),
    "falling ramp": (by_alpha(lambda n, t: ramp(n, t, (0.2, 1.0), (0.4, 0.0))), "ALPHA", 0.3, False),
    "mix from transparent": (
        lambda n, t: n.mix(t.outputs["Alpha"], n.clear(), n.diffuse()),
        *("ALPHA", 0.5, True),
    ),
    "mix to transparent": (lambda n, t: n.mix(t.outputs["Alpha"], n.diffuse(), n.clear()), "ALPHA", 0.5, False),
    "leaf lit through": (
        lambda n, t: n.add("AddShader", n.clear(), by_alpha(lambda n, t: t.outputs["Alpha"])(n, t)),
        *("ALPHA", 0.5, True),
    ),
}


@pytest.mark.parametrize("build, channel_name, turn, above_it", FOLLOWED.values(), ids=FOLLOWED.keys())
def test_opacity_is_followed_to_an_image(build, channel_name, turn, above_it):
    empty_scene()
    found = see_through.through(leaf(build))
    assert found.cut.channel == channel_name and not found.unknown and not found.is_enough

    def opaque(value):
        return found.cut.gain * value + found.cut.offset > found.cut.threshold

    assert (opaque(turn - 0.02), opaque(turn + 0.02)) == (not above_it, above_it)


NOT_FOLLOWED = {
    "noise": (by_alpha(lambda n, t: n.add("TexNoise")), "Noise Texture"),
    "generated coordinates": (
        by_alpha(lambda n, t: linked(n, n.add("TexCoord").node.outputs["Generated"], t)),
        "is not placed by a UV map",
    ),
    "two images": (
        by_alpha(lambda n, t: math_node(n, "MULTIPLY", t.outputs["Alpha"], t.outputs["Color"])),
        "Multiply",
    ),
    "a ramp of two steps": (by_alpha(lambda n, t: ramp(n, t, (0.2, 0.6), (0.4, 1.0))), "color ramp"),
    "no image": (by_alpha(lambda n, t: without_image(t)), "no image"),
    "mixed": (
        lambda n, t: n.mix(0.3, n.diffuse(), by_alpha(lambda n, t: t.outputs["Alpha"])(n, t)),
        "mixed with another shader",
    ),
}


def linked(nodes, socket, texture):
    nodes.tree.links.new(socket, texture.inputs["Vector"])
    return texture.outputs["Alpha"]


def without_image(texture):
    texture.image = None
    return texture.outputs["Alpha"]


@pytest.mark.parametrize("build, why", NOT_FOLLOWED.values(), ids=NOT_FOLLOWED.keys())
def test_what_cannot_be_followed_hides_as_a_whole_and_is_told_with_the_name_of_the_material(above, build, why):
    card(leaf(build, "Frond"))
    found = read(above)
    assert len(found.snapshot.surfaces[0].triangles) == 2 and found.snapshot.slots[0][0].hides
    assert [told for told in found.remarks if "'Frond' hides lines as a whole" in told and why in told]


def test_a_card_hides_a_line_exactly_where_its_image_is_opaque(above):
    card(leaf())
    new_object(
        new_mesh([(-1.5, -2, -1), (1.5, -2, -1), (1.5, 0.01, -1), (-1.5, 0.01, -1)], [], [(0, 1, 2, 3)]), "Behind"
    )
    behind = bpy.data.objects["Behind"]
    whole, seen = (length(api.lines("border", [behind], visible=visible)) for visible in (False, True))
    assert whole - seen == pytest.approx(2 * 2 * RADIUS, abs=2 * TEXEL)


def test_its_outline_is_that_of_the_cut_out_and_counts_as_border(above):
    square = card(leaf())
    found = api.lines("border", [square])
    assert length(found) == pytest.approx(2 * math.pi * 2 * RADIUS, abs=2 * math.pi * TEXEL)
    from_middle = np.hypot(found["points"][:, 0], found["points"][:, 1])
    assert np.abs(from_middle - 2 * RADIUS).max() < 0.5 * TEXEL
    assert not length(api.lines("crease", [square]))


def test_a_line_where_the_card_is_cut_by_another_surface_ends_at_the_cut_out(above):
    square = card(leaf())
    wall = new_mesh([(-2, 0, -1), (2, 0, -1), (2, 0, 1), (-2, 0, 1)], [], [(0, 1, 2, 3)])
    new_object(wall, "Wall")
    bpy.context.view_layer.update()
    assert length(api.lines("intersection")) == pytest.approx(2 * 2 * RADIUS, abs=2 * TEXEL)
    assert square.name == "Card"


def test_always_hides_as_a_whole_and_never_is_cut_out_but_hides_nothing(above):
    material = leaf()
    square = card(material)
    material.fovea.occlusion = "ALWAYS"
    assert length(api.lines("border", [square])) == pytest.approx(8.0)
    material.fovea.occlusion = "NEVER"
    assert length(api.lines("border", [square])) == pytest.approx(2 * math.pi * 2 * RADIUS, rel=0.02)
    assert read(above).snapshot.slots[0][0].hides is False


def test_glass_stays_see_through_as_a_whole(above):
    square = card(leaf(lambda nodes, texture: nodes.principled(Alpha=0.3)))
    assert length(api.lines("border", [square])) == pytest.approx(8.0)
    assert not read(above).snapshot.slots[0][0].hides


def test_only_faces_of_the_material_are_cut(above):
    square = card(leaf())
    mesh = square.data
    mesh.materials.append(bpy.data.materials.new("Bark"))
    mesh.polygons[0].material_index = 1
    assert length(api.lines("border", [square])) == pytest.approx(8.0)


def test_a_card_that_moves_is_not_cut_again(above):
    square, reader = card(leaf()), reading.Reader()
    chosen = style.load(style.DEFAULT)
    first = reader.read(bpy.context.evaluated_depsgraph_get(), chosen)
    for vertex in square.data.vertices:
        vertex.co.x *= 2
    square.data.update()
    second = reader.read(bpy.context.evaluated_depsgraph_get(), chosen)
    assert second.snapshot.surfaces[0] is first.snapshot.surfaces[0] and not second.built and second.changed
    width = np.ptp(second.snapshot.surfaces[0].positions[4:, 0])
    assert width == pytest.approx(2 * 2 * 2 * RADIUS, abs=2 * TEXEL)


def test_another_image_cuts_again(above):
    material = leaf()
    square = card(material)
    reader, chosen = reading.Reader(), style.load(style.DEFAULT)
    first = reader.read(bpy.context.evaluated_depsgraph_get(), chosen)
    image = next(node.image for node in material.node_tree.nodes if node.type == "TEX_IMAGE")
    image.pixels.foreach_set(np.ones(4 * TEXELS * TEXELS, np.float32))
    square.data.update()
    second = reader.read(bpy.context.evaluated_depsgraph_get(), chosen)
    assert len(first.snapshot.surfaces[0].triangles) > 20 and len(second.snapshot.surfaces[0].triangles) == 2


def test_far_away_a_card_has_fewer_points(above):
    above.camera.data.type = "PERSP"
    card(leaf(), "Near")
    near = len(read(above).snapshot.surfaces[0].triangles)
    above.camera.location.z = 400
    assert 2 < len(read(above).snapshot.surfaces[0].triangles) < near / 3


def test_a_mesh_without_the_uv_map_or_repaired_hides_as_a_whole_and_says_so(above):
    square = card(leaf())
    square.data.uv_layers.remove(square.data.uv_layers[0])
    assert any("lacks the UV map" in told and "'Leaf'" in told for told in read(above).remarks)
    assert length(api.lines("border", [square])) == pytest.approx(8.0)
    bpy.data.objects.remove(square)
    square = card(leaf())
    square.fovea.repair_orient = True
    assert any("repaired" in told for told in read(above).remarks)


def test_a_subdivided_card_is_cut_as_blender_subdivides_it(above):
    square = card(leaf())
    square.modifiers.new("Subdivision", "SUBSURF").levels = 2
    square.modifiers[0].boundary_smooth = "PRESERVE_CORNERS"
    bpy.context.view_layer.update()
    assert any("drawn as Blender subdivides it" in told for told in read(above).remarks)
    assert length(api.lines("border", [square])) == pytest.approx(2 * math.pi * 2 * RADIUS, rel=0.15)


@pytest.fixture
def colored(monkeypatch):
    """A picture seen from above in flat colors."""
    made = box_scene()
    bpy.data.objects.remove(bpy.data.objects["Box"])
    camera = made.camera
    camera.location, camera.rotation_euler = (0, 0, 5), (0, 0, 0)
    camera.data.type, camera.data.ortho_scale = "ORTHO", 2 * SIZE[0] / SIZE[1]
    original = part("render.properties").style_of
    flat = style.Color(shading="flat")
    monkeypatch.setattr(session.properties, "style_of", lambda *given: original(*given).replace(color=flat))
    return made


def color_of(scene, tmp_path):
    """(H, W, 3) of the Color pass."""
    found = layered(scene, tmp_path / "layer.exr")
    names = {name.rpartition("Color.")[2]: pixels for name, pixels in found.items() if "Color." in name}
    return np.stack([names[one] for one in "RGB"], 2)


def plain(color, name="Plain"):
    return leaf(lambda nodes, texture: nodes.principled(Base_Color=(*color, 1)), name)


def test_colors_fill_a_card_where_it_is_opaque(colored, tmp_path):
    card(leaf(), half=1.0)
    card(plain((1, 0, 0)), "Behind", 2.0, (0, 0, -1))
    found = color_of(colored, tmp_path)
    y, x = np.mgrid[: SIZE[1], : SIZE[0]]
    away = np.hypot(x + 0.5 - SIZE[0] / 2, y + 0.5 - SIZE[1] / 2) / (SIZE[1] / 2)
    leaves, ground = found[away < 2 * RADIUS - 0.06], found[away > 2 * RADIUS + 0.06]
    assert np.allclose(leaves, (0, 1, 0), atol=0.02) and np.allclose(ground, (1, 0, 0), atol=0.02)


def test_culled_backs_have_no_color_and_fronts_have(colored, tmp_path):
    material = plain((0, 1, 0), "Hull")
    material.use_backface_culling = True
    hull = card(material, half=0.5)
    card(plain((1, 0, 0)), "Behind", 2.0, (0, 0, -1))
    assert np.allclose(color_of(colored, tmp_path)[SIZE[1] // 2, SIZE[0] // 2], (0, 1, 0), atol=0.02)
    hull.rotation_euler.x = math.pi
    assert np.allclose(color_of(colored, tmp_path)[SIZE[1] // 2, SIZE[0] // 2], (1, 0, 0), atol=0.02)


def test_culled_backs_neither_hide_nor_have_lines(above):
    material = bpy.data.materials.new("Hull")
    material.use_backface_culling = True
    hull = card(material)
    behind = card(None, "Behind", 0.5, (0, 0, -2))

    def seen(obj):
        return length(api.lines("border", [obj], visible=True))

    assert (seen(hull), seen(behind)) == (pytest.approx(8.0), 0.0)
    hull.rotation_euler.x = math.pi
    assert (seen(hull), seen(behind)) == (0.0, pytest.approx(4.0))
    hull.rotation_euler.x, hull.scale.x = 0.0, -1.0
    assert (seen(hull), seen(behind)) == (pytest.approx(8.0), 0.0), "a mirrored front is a front"


def cut_card(*, one_sided=False):
    """A native surface of a card with a disc, or whole and one-sided."""
    verts, offsets = np.arange(4, dtype=np.int32), np.array([0, 4], np.int32)
    edges = core.PolygonEdges(offsets, verts)
    mesh = core.Mesh(
        positions=np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], np.float32),
        edge_verts=edges.edge_verts,
        corner_verts=verts,
        corner_edges=edges.corner_edges,
        polygon_offsets=offsets,
        one_sided=np.array([one_sided]),
    )
    at = (np.arange(32) + 0.5) / 32 - 0.5
    inside = np.clip(0.5 + 32 * (0.35 - np.hypot(*np.meshgrid(at, at))), 0, 1).astype(np.float32)
    uvs = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], np.float32)
    cuts = [] if one_sided else [core.Cut(uvs, core.Opacity(inside))]
    return core.CutSurface("Card", mesh, cuts, np.array([-1 if one_sided else 0], np.int32))


def foliage():
    """Cards that are cut out and others seen from one side, at random before each other."""
    rng, leaves, hull = np.random.default_rng(2), cut_card(), cut_card(one_sided=True)
    placed = []
    for i in range(60):
        turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        matrix = moved(rng.uniform(-2, 2, 3))
        matrix[:3, :3] = turn * 0.8  # some are mirrored
        placed.append((hull if i % 3 == 0 else leaves, matrix))
    return scene_of(placed)


@pytest.mark.gpu
@pytest.mark.parametrize("method", ["atlas", "item_buffer"])
@pytest.mark.parametrize("orthographic", [False, True])
def test_both_backends_agree_on_cut_outs_and_culled_backs(method, orthographic):
    frame = frame_of(foliage(), view_of(orthographic=orthographic), visibility=method)
    on_gpu, on_cpu = part("gpu.backend").Backend().visibility(frame), core.CpuBackend().visibility(frame)
    assert np.mean((on_gpu >= 0.5) == (on_cpu >= 0.5)) > 0.995
    assert 0.2 < np.mean(on_cpu) < 0.9
