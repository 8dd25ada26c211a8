# SPDX-License-Identifier: GPL-3.0-or-later
"""Base colors from every source, lights, and the color layer in pictures and passes."""

import bpy
import numpy as np
import pytest
from pictures import SIZE, box_scene, drawn, layered
from the_addon import box_mesh, new_mesh, new_object, part

session, style = part("render.session"), part("style")


@pytest.fixture
def scene(monkeypatch):
    """A square that fills the picture, seen from above, in flat colors and without lines."""
    made = box_scene()
    bpy.data.objects.remove(bpy.data.objects["Box"])
    camera = made.camera
    camera.location, camera.rotation_euler = (0, 0, 5), (0, 0, 0)
    camera.data.type, camera.data.ortho_scale = "ORTHO", 2 * SIZE[0] / SIZE[1]
    mesh = new_mesh([(-2, -2, 0), (2, -2, 0), (2, 2, 0), (-2, 2, 0)], [], [(0, 1, 2, 3)])
    layer = mesh.uv_layers.new(name="Other")
    layer.data.foreach_set("uv", np.zeros(8, np.float32))
    layer = mesh.uv_layers.new(name="Map")
    layer.data.foreach_set("uv", np.array([0, 0, 1, 0, 1, 1, 0, 1], np.float32))
    layer.active_render = True
    new_object(mesh, "Square")
    colored(monkeypatch, shading="flat")
    return made


def colored(monkeypatch, paper=None, **values):
    """Draws with a color layer, whatever the panel says."""
    original = part("render.properties").style_of

    def style_of(*given):
        found = original(*given)
        return found.replace(color=style.Color(**values), paper=found.paper.replace(**(paper or {})))

    monkeypatch.setattr(session.properties, "style_of", style_of)


def material(name="Material", viewport=(0.1, 0.2, 0.3)):
    made = bpy.data.materials.new(name)
    made.diffuse_color = (*viewport, 1)
    if made.node_tree is None:
        made.use_nodes = True
    return made, made.node_tree.nodes["Principled BSDF"], made.node_tree


def painted(square_material):
    mesh = bpy.data.objects["Square"].data
    mesh.materials.clear()
    mesh.materials.append(square_material)
    return mesh


def layer_of(scene, tmp_path):
    """(H, W, 3) of the Color pass, rows from the bottom."""
    found = layered(scene, tmp_path / "layer.exr")
    names = {name.rpartition("Color.")[2]: pixels for name, pixels in found.items() if "Color." in name}
    return np.stack([names[channel] for channel in "RGB"], 2)


def image(name, pixels, **settings):
    height, width, _ = pixels.shape
    made = bpy.data.images.new(name, width, height, alpha=True, **settings)
    made.pixels.foreach_set(pixels.astype(np.float32).ravel())
    return made


def textured(made, tree, shader):
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = made
    tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
    return node


def corners_of(picture):
    """Colors near the square's lower left, lower right, upper left and upper right, as the camera sees them."""
    height, width = picture.shape[:2]
    return [picture[y, x] for y in (height // 4, 3 * height // 4) for x in (width // 4, 3 * width // 4)]


QUARTERS = np.array([[(1, 0, 0, 1), (0, 1, 0, 1)], [(0, 0, 1, 1), (1, 1, 0, 1)]], float).repeat(8, 0).repeat(8, 1)


def test_the_principled_shader(scene, tmp_path):
    made, shader, _ = material()
    shader.inputs["Base Color"].default_value = (0.5, 0.25, 0.125, 1)
    painted(made)
    assert np.allclose(layer_of(scene, tmp_path), (0.5, 0.25, 0.125), atol=1e-4)


def test_nodes_that_are_not_followed_look_as_in_the_viewport(scene, tmp_path):
    made, shader, tree = material()
    tree.links.new(tree.nodes.new("ShaderNodeTexNoise").outputs["Color"], shader.inputs["Base Color"])
    painted(made)
    assert np.allclose(layer_of(scene, tmp_path), (0.1, 0.2, 0.3), atol=1e-4)


def test_emission_shines_by_itself(scene, tmp_path, monkeypatch):
    colored(monkeypatch, shading="smooth")
    made, _, tree = material()
    lamp = tree.nodes.new("ShaderNodeEmission")
    lamp.inputs["Color"].default_value = (0.7, 0.6, 0.1, 1)
    tree.links.new(lamp.outputs[0], tree.get_output_node("ALL").inputs["Surface"])
    painted(made)
    light = new_object(bpy.data.lights.new("Sun", "SUN"), "Sun")
    light.rotation_euler = (1.2, 0, 0)
    assert np.allclose(layer_of(scene, tmp_path), (0.7, 0.6, 0.1), atol=1e-4)


def pane(name, shader_values):
    """A red square above the other one."""
    mesh = new_mesh([(-2, -2, 1), (2, -2, 1), (2, 2, 1), (-2, 2, 1)], [], [(0, 1, 2, 3)])
    made, shader, _ = material(name)
    shader.inputs["Base Color"].default_value = (1, 0, 0, 1)
    for key, value in shader_values.items():
        shader.inputs[key].default_value = value
    mesh.materials.append(made)
    new_object(mesh, name)
    return made


def test_a_see_through_material_colors_what_lies_behind_it(scene, tmp_path):
    made, shader, _ = material()
    shader.inputs["Base Color"].default_value = (0, 0, 1, 1)
    painted(made)
    pane("Glass", {"Transmission Weight": 1.0})
    assert np.allclose(layer_of(scene, tmp_path), (0, 0, 1), atol=1e-4)
    film = pane("Film", {"Alpha": 0.25})
    assert np.allclose(layer_of(scene, tmp_path), (0.25, 0, 0.75), atol=1e-4)
    film.fovea.occlusion = "ALWAYS"
    assert np.allclose(layer_of(scene, tmp_path), (1, 0, 0), atol=1e-4)


def test_a_material_that_shall_hide_nothing_has_no_color(scene, tmp_path):
    made, shader, _ = material()
    shader.inputs["Base Color"].default_value = (0, 0, 1, 1)
    painted(made)
    pane("Wall", {}).fovea.occlusion = "NEVER"
    assert np.allclose(layer_of(scene, tmp_path), (0, 0, 1), atol=1e-4)


@pytest.mark.parametrize("kind", ["generated", "packed", "float"])
def test_an_image_lies_on_the_active_map(scene, tmp_path, kind):
    made, shader, tree = material()
    pixels = image("Quarters", QUARTERS, float_buffer=kind == "float")
    if kind == "packed":
        pixels.pack()
    textured(pixels, tree, shader)
    painted(made)
    for found, expected in zip(corners_of(layer_of(scene, tmp_path)), QUARTERS[[0, 0, 8, 8], [0, 8, 0, 8], :3]):
        assert np.allclose(found, expected, atol=0.01)


def test_bytes_are_decoded_as_their_color_space_says(scene, tmp_path):
    made, shader, tree = material()
    pixels = image("Gray", np.full((4, 4, 4), 0.5))
    pixels.pack()  # Blender makes generated ones anew for another color space
    textured(pixels, tree, shader)
    painted(made)
    assert np.allclose(layer_of(scene, tmp_path), 0.2140, atol=0.003)
    pixels.colorspace_settings.name = "Non-Color"
    assert np.allclose(layer_of(scene, tmp_path), 0.5, atol=0.005)


def test_an_image_that_is_painted_on_is_read_again(scene, tmp_path):
    made, shader, tree = material()
    pixels = image("Paint", QUARTERS)
    textured(pixels, tree, shader)
    painted(made)
    layer_of(scene, tmp_path)
    pixels.pixels.foreach_set(np.tile(np.array([0, 1, 1, 1], np.float32), 256))
    pixels.update()
    assert np.allclose(layer_of(scene, tmp_path), (0, 1, 1), atol=0.01)


def test_a_named_map_and_a_mapping(scene, tmp_path):
    made, shader, tree = material()
    node = textured(image("Quarters", QUARTERS), tree, shader)
    uv, mapping = tree.nodes.new("ShaderNodeUVMap"), tree.nodes.new("ShaderNodeMapping")
    uv.uv_map = "Other"  # all at the lower left corner
    mapping.inputs["Location"].default_value = (0.75, 0.25, 0)
    tree.links.new(uv.outputs[0], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs[0], node.inputs["Vector"])
    painted(made)
    assert np.allclose(layer_of(scene, tmp_path), (0, 1, 0), atol=0.01)


def test_a_missing_image_leaves_the_viewport_color(scene, tmp_path):
    made, shader, tree = material()
    pixels = bpy.data.images.new("Gone", 4, 4)
    pixels.source, pixels.filepath = "FILE", str(tmp_path / "gone.png")
    textured(pixels, tree, shader)
    painted(made)
    assert np.allclose(layer_of(scene, tmp_path), (0.1, 0.2, 0.3), atol=1e-4)


@pytest.mark.parametrize("domain, kind", [("POINT", "FLOAT_COLOR"), ("CORNER", "BYTE_COLOR")])
def test_an_attribute_of_the_mesh(scene, tmp_path, domain, kind):
    made, shader, tree = material()
    node = tree.nodes.new("ShaderNodeVertexColor")
    node.layer_name = "Tint"
    tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
    attribute = painted(made).color_attributes.new("Tint", kind, domain)
    attribute.data.foreach_set("color", np.tile(np.array([0.25, 0.5, 1, 1], np.float32), 4))
    assert np.allclose(layer_of(scene, tmp_path), (0.25, 0.5, 1), atol=0.01)


def test_a_mesh_without_materials_shows_its_active_colors(scene, tmp_path):
    mesh = bpy.data.objects["Square"].data
    assert np.allclose(layer_of(scene, tmp_path), 0.8, atol=1e-4)
    attribute = mesh.color_attributes.new("Col", "FLOAT_COLOR", "POINT")
    attribute.data.foreach_set("color", np.tile(np.array([0.9, 0.1, 0.1, 1], np.float32), 4))
    assert np.allclose(layer_of(scene, tmp_path), (0.9, 0.1, 0.1), atol=1e-4)


def test_several_materials_and_instances(scene, tmp_path):
    mesh = box_mesh(0.3)
    for name, shade in (("red", (1, 0, 0)), ("green", (0, 1, 0))):
        made, shader, _ = material(name)
        shader.inputs["Base Color"].default_value = (*shade, 1)
        mesh.materials.append(made)
    mesh.polygons[1].material_index = 1  # the top
    collection = bpy.data.collections.new("Boxes")
    new_object(mesh, "Box", (0, 0, 1), collection)
    for x in (-0.7, 0.7):
        empty = new_object(None, "Instance", (x, 0, 0))
        empty.instance_type, empty.instance_collection = "COLLECTION", collection
    picture = layer_of(scene, tmp_path)
    height, width = picture.shape[:2]
    for x in (-0.7, 0.7):
        at = width // 2 + round(x * height / 2)
        assert np.allclose(picture[height // 2, at], (0, 1, 0), atol=1e-4)
    assert np.allclose(picture[height // 2, width // 2], 0.8, atol=1e-4)


def test_a_subdivided_surface_keeps_its_maps(scene, tmp_path):
    made, shader, tree = material()
    textured(image("Quarters", QUARTERS), tree, shader)
    painted(made)
    square = bpy.data.objects["Square"]
    modifier = square.modifiers.new("Subdivision", "SUBSURF")
    modifier.render_levels = 3
    for found, expected in zip(corners_of(layer_of(scene, tmp_path)), QUARTERS[[0, 0, 8, 8], [0, 8, 0, 8], :3]):
        assert np.allclose(found, expected, atol=0.02)


@pytest.mark.parametrize("kind", ["SUN", "POINT", "SPOT", "AREA"])
def test_lights_shine_where_they_are(scene, tmp_path, monkeypatch, kind):
    colored(monkeypatch, shading="smooth")
    scene.world = None
    light = new_object(bpy.data.lights.new("Light", kind), "Light", (-1.2, 0, 1.5))
    light.data.energy, light.data.color = 10, (1, 0.5, 0.5)
    if kind == "SUN":
        light.rotation_euler = (0, 1.4, 0)
        new_object(box_mesh(0.3), "Box")
    picture = layer_of(scene, tmp_path)
    height, width = picture.shape[:2]
    bright, dim = picture[height // 2, width // 6], picture[height // 2, -width // 12]
    assert bright[0] > bright[1] and bright.max() <= 0.801
    assert kind == "SUN" or bright[0] > 1.2 * dim[0]


def test_the_picture_has_the_layer_under_the_lines(scene, tmp_path, monkeypatch):
    made, shader, _ = material()
    shader.inputs["Base Color"].default_value = (0, 0, 1, 1)
    painted(made)
    picture = drawn(scene, tmp_path / "flat.png")
    assert np.allclose(picture[SIZE[1] // 2, SIZE[0] // 2, :3], (0, 0, 1), atol=0.01)
    colored(monkeypatch, shading="flat", opacity=0.0)
    bare = drawn(scene, tmp_path / "clear.png")
    assert bare[..., :3].min() > 0.99


def test_paper_settles_pigment(scene, tmp_path, monkeypatch):
    grain = {"texture": "cold_press", "scale": 12.0}  # a texel per pixel of the small picture
    colored(monkeypatch, {**grain, "granulation": 0.6}, shading="flat")
    picture = drawn(scene, tmp_path / "grain.png")
    assert picture[..., 0].std() > 0.02
    colored(monkeypatch, {**grain, "granulation": 0.0}, shading="flat")
    assert drawn(scene, tmp_path / "even.png")[..., 0].std() < 1e-3


def test_a_plain_style_has_no_layer(scene, tmp_path, monkeypatch):
    colored(monkeypatch)
    assert not any("Color." in name for name in layered(scene, tmp_path / "plain.exr"))


def test_a_viewport_without_a_mesh_or_lights_is_still_drawn(scene, tmp_path):
    bpy.data.objects["Square"].data.clear_geometry()
    assert not layer_of(scene, tmp_path).any()
