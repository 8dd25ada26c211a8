# SPDX-License-Identifier: GPL-3.0-or-later
"""Every line definition of the registry, drawn by itself by `fovea draw` on a scene with features for each."""

import sys
from pathlib import Path

import bpy
import landscape
import numpy as np
import pytest
from pictures import ink, pixels_of
from the_addon import add_camera, box_mesh, empty_scene, mark_edges, new_mesh, new_object, part, use_style

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import draw
import sheet

NAMES = [definition["name"] for definition in part("catalogue").definitions()]
TILE = (320, 240)
LABELS = [definition["label"] for definition in part("catalogue").definitions()]


def landscape_mesh():
    """The landscape of two materials, with one row of its edges marked."""
    quads, row = landscape.quads(), landscape.COUNT // 4
    mesh = new_mesh(landscape.points().tolist(), [], quads, "Landscape")
    for name in ("Grass", "Rock"):
        mesh.materials.append(bpy.data.materials.new(name))
    mesh.polygons.foreach_set("material_index", (np.arange(len(quads)) > len(quads) // 3).astype(np.int32))
    mark_edges(mesh, freestyle=[e.index for e in mesh.edges if all(v % landscape.COUNT == row for v in e.vertices)])
    return mesh


@pytest.fixture(scope="module")
def blend(tmp_path_factory):
    """A file with the landscape and a box that cuts it, its lid cut off, in a low sun, seen from above."""
    scene = empty_scene()
    new_object(landscape_mesh(), "Landscape")
    new_object(box_mesh(0.4), "Box", (1.1, -1.0, 0.2)).rotation_euler.z = 0.4
    scene.fovea.section = new_object(None, "Cut", (0, 0, 0.5))
    new_object(bpy.data.lights.new("Sun", "SUN"), "Sun").rotation_euler = (1.2, 0.3, 0)
    add_camera((3.4, -5, 3.6), (0, -0.1, 0))
    scene.render.resolution_x, scene.render.resolution_y = 320, 200
    use_style(scene, "plain").line_sets[-1].pen.width = 10.0
    path = tmp_path_factory.mktemp("every") / "scene.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path


def words_for(blend, name):
    """Options of `fovea draw` that give a definition the file that it needs: a model of what is seen from its side."""
    file = part("catalogue").by_name()[name]["file"]
    if not file:
        return []
    path = blend.with_name("model.json")
    core, rows = part("native").load(), np.random.default_rng(1).uniform(-1, 1, (4000, 15)).astype(np.float32)
    facing = rows[:, [name for name, _ in core.LocalProperties.names].index("facing")]
    path.write_text(core.LineModel("tree", rows, np.float32(facing < 0.4), np.ones(4000, np.float32)).json())
    return ["--param", f"{name}.{file['name']}={path}"]


def said(output):
    """Lines of Blender's that report something."""
    return [line for line in output.splitlines() if any(word in line for word in ("Error", "Warning", "Info:"))]


@pytest.fixture(scope="module")
def drawn(blend):
    """(H, W) ink of a definition drawn alone by a backend, and what was said; each is drawn once."""
    kept = {}

    def by(backend, name, capfd):
        if (backend, name) not in kept:
            path = blend.with_name(f"{name}-{backend}.png")
            capfd.readouterr()
            draw.main([str(blend), "-o", str(path), "--lines", name, "--backend", backend, *words_for(blend, name)])
            kept[backend, name] = ink(pixels_of(path)), said("".join(capfd.readouterr()))
        return kept[backend, name]

    return by


@pytest.mark.parametrize("name", NAMES)
def test_a_definition_alone_gives_a_picture_and_no_message(drawn, name, capfd):
    picture, words = drawn("cpu", name, capfd)
    assert picture.shape == (200, 320) and not words
    assert 0.0005 < (picture > 0.3).mean() < 0.5


def test_what_is_said_would_be_seen(blend, capfd):
    bpy.ops.wm.open_mainfile(filepath=str(blend))
    bpy.data.meshes["Landscape"].vertices[0].co.x = np.nan
    bpy.context.scene.render.engine = "FOVEA"
    bpy.ops.render.render()
    assert said("".join(capfd.readouterr()))


def test_no_two_definitions_draw_the_same(drawn, capfd):
    pictures = [drawn("cpu", name, capfd)[0] for name in NAMES]
    alike = [
        (a, b)
        for i, a in enumerate(NAMES)
        for j, b in enumerate(NAMES[:i])
        if np.abs(pictures[i] - pictures[j]).max() < 0.3
    ]
    assert not alike


@pytest.mark.parametrize("name", NAMES)
def test_the_gpu_draws_every_definition_as_the_cpu_does(drawn, name, capfd):
    if part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    picture, _ = drawn("gpu", name, capfd)
    assert part("render.session").last_statistics()["backend"] == "gpu"
    assert np.abs(picture - drawn("cpu", name, capfd)[0]).mean() < 0.002


@pytest.fixture(scope="module")
def contact_sheet(blend):
    path = blend.with_name("sheet.png")
    given = [word for name in NAMES for word in words_for(blend, name)]
    draw.main([str(blend), "-o", str(path), "--sheet", "--lines", "all", "--size", f"{TILE[0]}x{TILE[1]}", *given])
    return path


def test_a_sheet_has_a_labelled_tile_for_every_definition(contact_sheet):
    page, (width, height) = ink(pixels_of(contact_sheet))[::-1], TILE
    columns, whole = sheet.columns_for(len(NAMES), TILE), height + sheet.strip(TILE)
    rows = -(-len(NAMES) // columns)
    assert page.shape == (rows * whole, columns * width)
    tiles = page.reshape(rows, whole, columns, width).swapaxes(1, 2).reshape(-1, whole, width)
    tiles, strips = tiles[:, :height], tiles[:, height:]
    assert all(strip.max() > 0.5 and strip[:, :2].max() == 0 for strip in strips[: len(NAMES)])
    assert (tiles[len(NAMES) :] == 0).all() and (strips[len(NAMES) :] == 0).all()
    assert len({strip.tobytes() for strip in strips[: len(NAMES)]}) == len(set(LABELS)) == len(NAMES)
    # The shape is in every tile, paler than the lines.
    drawn_tiles = tiles[: len(NAMES)]
    shape = drawn_tiles.min(axis=0)
    assert (shape > 0.1).mean() > 0.003 and shape.max() < 0.7
    assert all(tile.max() > 0.7 for tile in drawn_tiles)
    assert len({tile.tobytes() for tile in drawn_tiles}) == len(NAMES)


def test_on_a_sheet_what_has_no_light_is_in_a_sun(tmp_path):
    scene = empty_scene()
    new_object(landscape_mesh(), "Landscape")
    new_object(box_mesh(0.4), "Box", (0.3, 0.2, 1.2))
    add_camera((3.4, -5, 3.6), (0, -0.1, 0))
    use_style(scene, "plain")
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "dark.blend"))
    path, words = tmp_path / "sheet.png", ["--sheet", "--lines", "light_contour,cast_shadow"]
    draw.main([*map(str, (tmp_path / "dark.blend", "-o", path)), *words, "--size", f"{TILE[0]}x{TILE[1]}"])
    page, (width, height) = ink(pixels_of(path))[::-1], TILE
    assert page.shape == (height + sheet.strip(TILE), 2 * width)
    assert all((tile[:height] > 0.7).mean() > 0.001 for tile in np.split(page, 2, axis=1))


def test_a_sheet_is_a_small_gray_file(contact_sheet):
    header = contact_sheet.read_bytes()[24:26]  # bit depth and color type of a PNG
    assert tuple(header) == (8, 0)
    assert contact_sheet.stat().st_size < 300_000


@pytest.mark.parametrize("size", [(480, 360), (160, 120), (300, 300)])
@pytest.mark.parametrize("count", [1, 5, 18, 23])
def test_columns_bring_a_sheet_near_to_16_by_9(size, count):
    columns = sheet.columns_for(count, size)
    rows = -(-count // columns)
    assert 1 <= columns <= count
    assert count < 5 or 1.1 < columns * size[0] / (rows * (size[1] + sheet.strip(size))) < 2.5


@pytest.mark.parametrize(
    "words, reason",
    [
        (["--lines", "creese"], "there is no line definition 'creese'"),
        (["--param", "crease=3"], "is named DEFINITION.NAME"),
        (["--param", "crease.angel=3"], "unknown keys: angel; known are: angle"),
        (["--param", "crease.angle=400"], "crease.angle is 400, outside 0 to 180"),
        (["--param", "crease.angle=40", "--lines", "contour"], "crease is not drawn; name it in --lines"),
    ],
)
def test_draw_refuses_mistakes_by_name(blend, tmp_path, words, reason):
    with pytest.raises(ValueError, match=reason):
        draw.main([str(blend), "-o", str(tmp_path / "none.png"), *words])
    assert not (tmp_path / "none.png").exists()


def test_a_parameter_changes_the_picture(blend, tmp_path):
    few, many = tmp_path / "few.png", tmp_path / "many.png"
    for path, count in ((few, 2), (many, 30)):
        draw.main([str(blend), "-o", str(path), "--lines", "isophote", "--param", f"isophote.count={count}"])
    assert ink(pixels_of(many)).sum() > 2 * ink(pixels_of(few)).sum()
