# SPDX-License-Identifier: GPL-3.0-or-later
"""The passes of a view layer: those that its panel lists are those that a file has, and what is in them."""

import itertools
import json
import re
import subprocess
from pathlib import Path

import bpy
import numpy as np
import pytest
from pictures import box_scene, drawn, layered
from the_addon import box_mesh, new_object, part, use_style

passes, session, style = part("render.passes"), part("render.session"), part("style")

PAGE = Path(__file__).parents[2] / "addon" / "docs" / "passes.md"


def wanted(scene):
    """Names of the passes that renders of a scene's first view layer have."""
    return [name for names in session.wanted_passes(scene, scene.view_layers[0]).values() for name in names]


def look_at_a_place(scene):
    place = style.FocusPlace(at=(0.5, 0.5, 0.0), near=0.1, far=0.5)
    part("focus.focus_settings").set_focus(scene.fovea, style.Focus(model="image", points=(place,)))


@pytest.mark.parametrize("color, focus, depth", itertools.product([False, True], repeat=3))
def test_passes_that_are_listed_are_in_the_file(tmp_path, color, focus, depth):
    scene = box_scene()
    use_style(scene, "watercolor" if color else "plain")
    if focus:
        look_at_a_place(scene)
    scene.view_layers[0].use_pass_z = depth
    has = {"Color": color, "Focus": focus, "Depth": depth}
    assert wanted(scene) == ["Lines", *(name for name, there in has.items() if there)]
    channels = layered(scene, tmp_path / "layers.exr")
    assert passes_of(channels) == {"Combined", *wanted(scene)}


def passes_of(channels):
    """Names of the passes of a file's channels, Layer.Pass.Channel."""
    return {name.split(".")[1] for name in channels}


def pass_of(channels, name):
    """(H, W) or (H, W, channels) of a pass."""
    letters = next(each.channels for each in passes.PASSES if name.startswith(each.name) and each.name != "Lines")
    found = [channels[f"ViewLayer.{name}.{letter}"] for letter in letters]
    return found[0] if len(found) == 1 else np.stack(found, axis=-1)


def lines_of(channels):
    return np.stack([channels[f"ViewLayer.Lines.{letter}"] for letter in "RGBA"], axis=-1)


def two_boxes():
    """One box before another, in two line sets with hidden lines, and every pass of lines on."""
    scene = box_scene()
    new_object(box_mesh(0.8), "Behind", (-1.5, 2.0, 0.0))
    hidden = style.Hidden(pen=style.Pen(width=8.0))
    sets = {"Contours": "contour", "Inner lines": "crease"}
    of = {"pen": style.Pen(width=20.0), "hidden": (hidden,)}
    use_style(
        scene, style.Style(line_sets=[style.LineSet(name=name, kinds={kind: {}}, **of) for name, kind in sets.items()])
    )
    layer = scene.view_layers[0]
    layer.use_pass_cryptomatte_object = True
    for name in ("hidden_lines", "line_sets", "line_depth", "line_id"):
        setattr(layer.fovea, name, True)
    return scene


@pytest.fixture(scope="module")
def channels(tmp_path_factory):
    """Channels of the file of two boxes."""
    return layered(two_boxes(), tmp_path_factory.mktemp("passes") / "layers.exr")


def test_every_pass_that_is_on_has_its_channels_in_the_file(channels):
    mattes = {"CryptoObject00", "CryptoObject01", "CryptoObject02"}
    sets = {"Lines_Contours", "Lines_Inner_lines"}
    assert passes_of(channels) == {"Combined", "Lines", "LinesHidden", "LineDepth", "LineId", *sets, *mattes}


def test_hidden_lines_under_the_line_sets_in_their_order_make_the_lines(channels):
    made = np.zeros_like(lines_of(channels))
    for name in ("LinesHidden", "Lines_Contours", "Lines_Inner_lines"):
        layer = pass_of(channels, name)
        assert layer[..., 3].max() > 0.5, name
        made = layer + made * (1 - layer[..., 3:])
    np.testing.assert_allclose(made, lines_of(channels), atol=2e-6)


def test_the_depth_of_lines_is_finite_just_where_they_have_ink_and_lies_on_the_boxes(channels):
    depth, alpha = pass_of(channels, "LineDepth"), lines_of(channels)[..., 3]
    assert ((depth < 1e9) == (alpha > 0)).all() and (depth[alpha == 0] == np.float32(1e10)).all()
    away = np.linalg.norm((5, -7, 4))
    assert away - 3**0.5 < depth.min() < away - 1 and away < depth[alpha > 0].max() < away + 4


def test_ids_of_lines_are_whole_numbers_above_0_just_where_there_is_ink(channels):
    ids, alpha = pass_of(channels, "LineId"), lines_of(channels)[..., 3]
    assert ((ids > 0) == (alpha > 0)).all() and (ids == np.round(ids)).all() and ids.max() < 1 << 24
    assert len(np.unique(ids)) > 8


def test_a_cryptomatte_adds_up_to_the_ink_of_the_lines_and_names_their_objects(channels):
    ranks = [pass_of(channels, f"CryptoObject{i:02d}") for i in range(3)]
    shares = sum(each[..., 1] + each[..., 3] for each in ranks)
    np.testing.assert_allclose(shares, lines_of(channels)[..., 3], atol=2e-6)
    ids = np.concatenate([each[..., [0, 2]].ravel() for each in ranks])
    core = part("native").load()
    known = [np.uint32(core.cryptomatte_id(name)).view(np.float32) for name in ("Box", "Behind")]
    assert set(np.unique(ids)) == {np.float32(0.0), *known}


def test_the_file_tells_the_names_of_a_cryptomatte(tmp_path):
    scene = two_boxes()
    layered(scene, tmp_path / "layers.exr")
    words = ["oiiotool", "--info", "-v", "-a", str(tmp_path / "layers.exr")]
    said = subprocess.run(words, capture_output=True, text=True, check=True).stdout.splitlines()
    # As names of layers are hashed, too: the first 7 of 8 digits.
    key = f"{part('native').load().murmur_hash('ViewLayer.CryptoObject'):08x}"[:7]
    told = dict(line.strip().split(": ", 1) for line in said if "cryptomatte/" in line)
    assert told[f"cryptomatte/{key}/hash"] == '"MurmurHash3_32"'
    manifest = json.loads(told[f"cryptomatte/{key}/manifest"][1:-1].replace('\\"', '"'))
    assert manifest == {name: f"{part('native').load().cryptomatte_id(name):08x}" for name in ("Box", "Behind")}


def test_the_page_on_passes_has_each_with_its_channels_and_what_the_panel_calls_it():
    rows = re.findall(r"^\| `(\w+)`[^|]*\| (\w+) \| ([^|]+) \|", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
    told = {re.sub("NAME$|00$", "", name): (channels, switch) for name, channels, switch in rows}
    assert told.keys() == {"Combined", *(each.name for each in passes.PASSES)}
    for each in passes.PASSES:
        channels, switch = told[each.name]
        assert channels == each.channels and (switch == f"*{each.label}*") == bool(each.switch)


def test_what_is_off_asks_nothing_of_the_core():
    layer = box_scene().view_layers[0]
    layer.use_pass_z = False
    asked = part("pipeline").options(**passes.options(layer))
    assert asked == part("pipeline").options(with_focus=True)


@pytest.mark.parametrize(
    "names, made",
    [
        (["Contours", "Inner lines"], ["Lines_Contours", "Lines_Inner_lines"]),
        (["a b", "a.b", "a/b"], ["Lines_a_b", "Lines_a_b_2", "Lines_a_b_3"]),
        (["Détail", "Umriß"], ["Lines_Detail", "Lines_Umri_8a7419fb"]),
        (["線", "..."], ["Lines_e8b25d12", "Lines_1a43b61b"]),
        (["lines", "lines"], ["Lines_lines"]),
    ],
)
def test_names_of_line_sets_become_names_of_passes(names, made):
    found = list(passes.names_of_line_sets(names).values())
    assert found == made
    assert all(name.isascii() and len(name) < 50 and "." not in name for name in found)


def new_compositor(scene):
    """An empty tree of nodes for compositing, and its output."""
    if hasattr(scene, "compositing_node_group"):
        tree = scene.compositing_node_group = bpy.data.node_groups.new("Compositing", "CompositorNodeTree")
        tree.interface.new_socket(name="Image", in_out="OUTPUT", socket_type="NodeSocketColor")
        return tree, tree.nodes.new("NodeGroupOutput")
    scene.use_nodes = True
    scene.node_tree.nodes.clear()
    return scene.node_tree, scene.node_tree.nodes.new("CompositorNodeComposite")


def sockets(node):
    return {socket.name for socket in node.outputs if socket.enabled}


def layers_node(tree, scene):
    node = tree.nodes.new("CompositorNodeRLayers")
    node.scene = scene
    return node


def test_sockets_of_the_compositor_appear_as_soon_as_a_pass_is_on_and_go_with_it():
    scene = box_scene()
    settings = scene.view_layers[0].fovea
    node = layers_node(new_compositor(scene)[0], scene)
    other = bpy.data.scenes.new("Other")
    of_other = layers_node(new_compositor(other)[0], scene)
    assert "Lines" in sockets(node) and "LineDepth" not in sockets(node)
    settings.line_depth = settings.line_sets = True
    for each in (node, of_other):
        assert {"LineDepth", "Lines_lines"} <= sockets(each)
    settings.line_depth = False
    for each in (node, of_other):
        assert "LineDepth" not in sockets(each)


def test_sockets_follow_the_names_of_line_sets_and_the_content_of_the_style():
    scene = box_scene()
    node = layers_node(new_compositor(scene)[0], scene)
    scene.view_layers[0].fovea.line_sets = True
    assert "Color" not in sockets(node) and {"Lines_lines", "Lines_marks"} <= sockets(node)
    scene.fovea.style.fovea.line_sets["marks"].name = "Hair"
    bpy.context.view_layer.update()
    assert "Lines_Hair" in sockets(node) and "Lines_marks" not in sockets(node)
    use_style(scene, "watercolor")
    bpy.context.view_layer.update()
    assert "Color" in sockets(node)


def test_blenders_cryptomatte_node_picks_the_lines_of_an_object_by_its_name(tmp_path):
    scene = two_boxes()
    tree, output = new_compositor(scene)
    node = tree.nodes.new("CompositorNodeCryptomatteV2")
    node.source, node.scene, node.layer_name = "RENDER", scene, "ViewLayer.CryptoObject"
    tree.links.new(node.outputs["Matte"], output.inputs[0])
    layers_node(tree, scene)
    mattes = []
    scene.view_settings.view_transform = "Raw"
    for name in ("Box", "Behind", "Box,Behind", "Nobody"):
        node.matte_id = name
        mattes.append(drawn(scene, tmp_path / "matte.png")[..., 0])
    box, behind, both, nobody = mattes
    assert box.max() > 0.9 and behind.max() > 0.9 and not nobody.any()
    np.testing.assert_allclose(np.minimum(box + behind, 1), both, atol=0.02)
    assert (box[behind > 0.9] < 0.2).all()


def test_blenders_cryptomatte_node_picks_them_in_a_file_too(tmp_path):
    scene = two_boxes()
    layered(scene, tmp_path / "crypto.exr")
    if hasattr(scene.render.image_settings, "media_type"):
        scene.render.image_settings.media_type = "IMAGE"
    tree, output = new_compositor(scene)
    node = tree.nodes.new("CompositorNodeCryptomatteV2")
    node.source, node.image = "IMAGE", bpy.data.images.load(str(tmp_path / "crypto.exr"))
    assert node.layer_name == "ViewLayer.CryptoObject"
    tree.links.new(node.outputs["Matte"], output.inputs[0])
    layers_node(tree, scene)
    scene.view_settings.view_transform = "Raw"
    ink = []
    for name in ("Box", "Behind", "Nobody"):
        node.matte_id = name
        ink.append(drawn(scene, tmp_path / "matte.png")[..., 0].sum())
    assert ink[0] > 20 and ink[1] > 20 and ink[2] == 0


def test_passes_of_a_mix_of_styles_are_those_of_both_in_every_frame(tmp_path):
    scene = box_scene()
    data = part("style.style_data")
    for name, line_set in zip(("One", "Two"), ("plain", "technical")):
        tree = data.new(name, style.named(line_set))
        tree.fovea.line_sets[0].name = name
        setattr(scene.fovea, "style" if name == "One" else "mixed_style", tree)
    scene.view_layers[0].fovea.line_sets = True
    expected = {name for name in wanted(scene) if name.startswith("Lines_")}
    assert {"Lines_One", "Lines_Two"} <= expected
    for mix in (0.0, 0.5, 1.0):
        scene.fovea.mix = mix
        assert expected <= passes_of(layered(scene, tmp_path / f"{mix}.exr"))


def test_a_scene_of_lines_over_renders_of_another_one_has_passes_of_lines_and_no_others(tmp_path):
    scene = two_boxes()
    scene.render.engine = "BLENDER_WORKBENCH"
    assert bpy.ops.fovea.lines_over() == {"FINISHED"}
    lines = part("render.lines_scenes").of(scene)
    layer = lines.view_layers[0]
    layer.fovea.hidden_lines = layer.fovea.line_sets = layer.fovea.line_depth = layer.use_pass_z = True
    assert wanted(lines) == ["Lines", "LinesHidden", "Lines_Contours", "Lines_Inner_lines", "LineDepth"]
    bpy.context.window.scene = lines
    channels = layered(lines, tmp_path / "layers.exr")
    assert passes_of(channels) == {"Combined", *wanted(lines)}
    assert all(channels[name].any() for name in channels if name.endswith(".A"))
