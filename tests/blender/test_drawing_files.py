# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of drawings as other programs read them, beside the film of the same scene; layers, pictures of one bit, and
files with every render."""

import io
import sys
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

import bpy
import numpy as np
import pytest
from pictures import box_scene, drawn, ink, pixels_of
from programs import program, ran
from the_addon import add_hidden, lines_of, own_style, part, shader_material, use_style

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import draw

vectors = part("render.vectors")
HEIGHT_MM = 210


@pytest.fixture
def scene():
    """A box with lines thick enough that their ink is more than edges of pixels."""
    scene = box_scene()
    style = use_style(scene, "plain")
    style.elision.enabled = False
    lines_of(scene).pen.width = 12.0
    scene.render.resolution_x, scene.render.resolution_y = 640, 480
    return scene


@pytest.fixture
def with_hidden(scene):
    add_hidden(lines_of(scene))
    return scene


def coverage(film):
    """(H, W) share of each pixel that black lines cover: films mix light, not values as they are displayed."""
    shown = film[..., :3].mean(axis=2)
    return 1 - np.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


def exported(path, **words):
    assert bpy.ops.fovea.export_vectors(filepath=str(path), kind=path.suffix[1:], **words) == {"FINISHED"}
    return path


@pytest.mark.parametrize("changing", [False, True], ids=["lines of one width", "outlines"])
def test_an_svg_is_as_inked_as_the_film_within_a_hundredth(scene, tmp_path, changing):
    converter = program("rsvg-convert")
    lines_of(scene).pen.pressure = 0.8 if changing else 0.0
    film = coverage(drawn(scene, tmp_path / "film.png"))
    svg = exported(tmp_path / "box.svg")
    ran(program("xmllint"), "--noout", svg)
    ran(converter, "-w", 640, "-h", 480, svg, "-o", tmp_path / "svg.png")
    vector = ink(pixels_of(tmp_path / "svg.png"))
    assert abs(vector.sum() - film.sum()) < 0.01 * film.sum()
    assert (np.abs(vector - film) > 0.5).sum() < 0.01 * film.sum()  # where they are, too


def test_lines_that_leave_the_picture_end_at_its_border_and_are_as_inked_as_in_the_film(scene, tmp_path):
    converter = program("rsvg-convert")
    scene.camera.data.lens *= 3
    film = coverage(drawn(scene, tmp_path / "film.png"))
    ran(converter, "-w", 640, "-h", 480, exported(tmp_path / "box.svg"), "-o", tmp_path / "svg.png")
    vector = ink(pixels_of(tmp_path / "svg.png"))
    assert film[0].max() > 0.9 and abs(vector.sum() - film.sum()) < 0.01 * film.sum()
    sheet = exported(tmp_path / "sheet.svg", sheet="a4", margin=30.0)  # the picture is 200 x 150 mm
    ran(converter, "-w", 297, "-h", 210, sheet, "-o", tmp_path / "sheet.png")
    beside = ink(pixels_of(tmp_path / "sheet.png"))
    inside = beside[28:-28, 46:-46].copy()
    beside[28:-28, 46:-46] = 0
    assert inside.sum() > 100 and beside.sum() == 0


@pytest.mark.parametrize(("kind", "share"), [("svg", 0.02), ("pdf", 0.03)])  # pdftoppm makes areas wider
def test_colors_as_areas_are_the_picture_s_but_at_edges(scene, tmp_path, kind, share):
    converter = program("rsvg-convert" if kind == "svg" else "pdftoppm")
    mesh = scene.objects["Box"].data
    for color in ((0.6, 0.1, 0.05, 1), (0.05, 0.1, 0.6, 1)):
        material = shader_material("Plain", "ShaderNodeEmission")
        material.node_tree.nodes["Emission"].inputs["Color"].default_value = color
        mesh.materials.append(material)
    mesh.polygons.foreach_set("material_index", [0, 1] * (len(mesh.polygons) // 2))
    own_style(scene).color.shading = "FLAT"
    lines_of(scene).pen.opacity = 0.0
    film = drawn(scene, tmp_path / "film.png")
    file, picture = exported(tmp_path / f"box.{kind}", colors="areas"), tmp_path / "areas.png"
    assert b"<image" not in file.read_bytes() and b"/Image" not in file.read_bytes()
    if kind == "svg":
        ran(converter, "-w", 640, "-h", 480, file, "-o", picture)
    else:
        ran(converter, "-png", "-scale-to-x", 640, "-scale-to-y", 480, "-singlefile", file, picture.with_suffix(""))
    differs = np.abs(pixels_of(picture)[..., :3] - film[..., :3]).max(axis=2) > 0.03
    colored = np.abs(film[..., :3] - film[0, 0, :3]).max(axis=2) > 0.03
    assert colored.mean() > 0.02 and differs.sum() < share * colored.sum()


def test_a_pdf_has_one_page_of_the_paper_s_size_and_the_same_ink(scene, tmp_path):
    to_picture, told = program("pdftoppm"), program("pdfinfo")
    film = coverage(drawn(scene, tmp_path / "film.png"))
    pdf = exported(tmp_path / "box.pdf")
    said = " ".join(ran(told, pdf).split())
    assert "Pages: 1 " in said and "Page size: 793.7" in said and " x 595.2" in said  # 280 x 210 mm in points
    ran(to_picture, "-png", "-scale-to-x", 640, "-scale-to-y", 480, "-singlefile", pdf, tmp_path / "pdf")
    vector = ink(pixels_of(tmp_path / "pdf.png"))
    assert abs(vector.sum() - film.sum()) < 0.03 * film.sum()  # its rasterizer makes strokes wider


def test_a_dxf_has_no_errors_and_its_layers(with_hidden, tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="there is no ezdxf here")
    document = ezdxf.readfile(exported(tmp_path / "box.dxf"))
    assert not document.audit().errors
    assert {"LINES_VISIBLE", "LINES_HIDDEN"} <= {layer.dxf.name for layer in document.layers}
    assert document.units == 4 and len(document.modelspace()) > 10  # millimeters


def layers_of(path):
    """{name in the stack: (H, W, 4) of 0 to 255, top row first} of an OpenRaster file, from above, and the picture."""
    with zipfile.ZipFile(path) as archive:
        first = archive.infolist()[0]
        assert (first.filename, first.compress_type) == ("mimetype", zipfile.ZIP_STORED)
        assert path.read_bytes()[38:54] == archive.read("mimetype") == b"image/openraster"
        root = ElementTree.parse(io.BytesIO(archive.read("stack.xml"))).getroot()
        names = set(archive.namelist())
        assert {"mergedimage.png", "Thumbnails/thumbnail.png"} < names
        found = {}
        for group in [root.find("stack"), *root.findall("stack/stack")]:
            for layer in group.findall("layer"):
                name = "/".join(filter(None, (group.get("name"), layer.get("name"))))
                found[name] = read_png(archive.read(layer.get("src")), path.parent)
        return root, found, read_png(archive.read("mergedimage.png"), path.parent)


def read_png(content, folder):
    file = folder / "layer.png"
    file.write_bytes(content)
    return pixels_of(file)


def test_an_openraster_file_has_lines_and_paper_apart_and_mixed_they_are_the_picture(with_hidden, tmp_path):
    film = drawn(with_hidden, tmp_path / "film.png")
    root, layers, merged = layers_of(exported(tmp_path / "box.ora"))
    assert (root.get("w"), root.get("h")) == ("640", "480")
    own = [name for name in layers if "/" in name]
    assert set(layers) == {"paper", *own} and {"hidden", "visible"} == {name.split("/")[1] for name in own}
    assert np.abs(merged[..., :3] - film[..., :3]).max() < 0.02
    mixed = np.zeros_like(film[..., :3])
    order = ["paper", *sorted(own)]
    for layer in (layers[name] for name in order):
        mixed = (1 - layer[..., 3:]) * mixed + layer[..., 3:] * layer[..., :3]
    assert np.abs(mixed - film[..., :3]).mean() < 0.002
    assert exported(tmp_path / "again.ora").read_bytes() == (tmp_path / "box.ora").read_bytes()


def test_colors_of_an_openraster_file_are_a_layer_of_their_own(scene, tmp_path):
    own_style(scene).color.shading = "FLAT"
    _, layers, merged = layers_of(exported(tmp_path / "box.ora"))
    colors = layers["colors"]
    assert colors[..., 3].max() > 0.99 and colors[..., 3].min() == 0
    inside = (colors[..., 3] > 0.99) & (sum(layers[name][..., 3] for name in layers if "/" in name) == 0)
    assert inside.any() and np.abs(colors[inside][:, :3] - merged[inside][:, :3]).max() < 0.01


def test_a_picture_of_one_bit_is_as_large_as_its_page_and_black_where_lines_are(scene, tmp_path):
    own_style(scene).color.shading = "FLAT"
    path = exported(tmp_path / "box.png", dpi=100.0, lines_per_inch=10.0)
    content = path.read_bytes()
    height = round(HEIGHT_MM / 25.4 * 100)
    assert int.from_bytes(content[20:24], "big") == height and content[24:26] == b"\x01\x00"  # bits, gray
    assert b"pHYs" + (3937).to_bytes(4, "big") in content
    picture = pixels_of(path)[..., 0]
    assert picture.shape[0] == height and set(np.unique(picture)) == {0, 1}
    assert (scene.render.resolution_x, scene.render.resolution_y) == (640, 480)
    assert exported(tmp_path / "again.png", dpi=100.0, lines_per_inch=10.0).read_bytes() == content


def test_a_page_whose_dots_are_too_small_is_told(scene, tmp_path):
    with pytest.raises(RuntimeError, match="dots are smaller than two pixels"):
        exported(tmp_path / "box.png", dpi=50.0, lines_per_inch=100.0)
    assert not (tmp_path / "box.png").exists()


def test_every_render_writes_vectors_beside_its_picture(scene, tmp_path):
    scene.fovea.vectors.kind = "SVG"
    scene.fovea.vectors.sheet = "a4"
    drawn(scene, tmp_path / "still.png")
    expected = exported(tmp_path / "expected.svg", sheet="a4").read_bytes()
    assert (tmp_path / "still_0001.svg").read_bytes() == expected
    scene.frame_start, scene.frame_end, scene.render.filepath = 3, 4, str(tmp_path / "new" / "a_##")
    bpy.ops.render.render(animation=True)
    assert sorted(file.name for file in (tmp_path / "new").iterdir()) == [
        "a_03.png",
        "a_03.svg",
        "a_04.png",
        "a_04.svg",
    ]
    assert (tmp_path / "new" / "a_04.svg").read_bytes() == expected
    scene.fovea.vectors.kind = "ORA"
    drawn(scene, tmp_path / "still.png")
    assert layers_of(tmp_path / f"still_{scene.frame_current:04d}.ora")[1]


def test_view_layers_have_files_of_their_own(scene, tmp_path):
    scene.fovea.vectors.kind = "DXF"
    scene.view_layers.new("Front/Back")
    drawn(scene, tmp_path / "two.png")
    names = sorted(file.name for file in tmp_path.iterdir())
    assert names == ["two.png", "two_0001_Front_Back.dxf", "two_0001_ViewLayer.dxf"]


def test_without_its_vectors_a_render_fails_in_a_sentence(scene, tmp_path):
    scene.fovea.vectors.kind = "SVG"
    scene.fovea.vectors.sheet, scene.fovea.vectors.margin = "a5", 80.0
    with pytest.raises(RuntimeError, match="leaves no room"):
        drawn(scene, tmp_path / "still.png")
    assert not list(tmp_path.iterdir())


def test_sequences_have_the_frame_s_number_where_rows_of_hashes_are(scene, tmp_path):
    box = scene.objects["Box"]
    for frame, place in ((1, 0.0), (2, 1.0)):
        box.location.x = place
        box.keyframe_insert("location", frame=frame)
    scene.fovea.vectors.kind = "PDF"  # which a run of its own output does not write
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "box.blend"))
    draw.main([str(tmp_path / "box.blend"), "--frames", "1-2", "-o", str(tmp_path / "x_###_y.svg")])
    files = {file.name: file.read_bytes() for file in tmp_path.glob("*.svg")}
    assert sorted(files) == ["x_001_y.svg", "x_002_y.svg"] and len(set(files.values())) == 2
    draw.main([str(tmp_path / "box.blend"), "-o", str(tmp_path / "x.ora")])
    draw.main(
        [str(tmp_path / "box.blend"), "-o", str(tmp_path / "x.png"), "--one-bit", "--dpi", "72", "--screen", "12"]
    )
    assert pixels_of(tmp_path / "x.png").shape[0] == round(HEIGHT_MM / 25.4 * 72)
    assert not list(tmp_path.glob("*.pdf")) and (tmp_path / "x.ora").exists()
