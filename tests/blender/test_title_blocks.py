# SPDX-License-Identifier: GPL-3.0-or-later
"""Title blocks of drawings, whose texts scenes keep: found again in files by other programs."""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from types import SimpleNamespace

import bpy
import pytest
from panel_layouts import RecordingLayout, full_scene, shown_by
from pictures import box_scene
from programs import program, ran
from the_addon import own_style, part

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import draw

api, vectors, native = part("render.api"), part("render.vectors"), part("native")
SVG = "{http://www.w3.org/2000/svg}"
SAID = {
    "title": "Küche <Süd> & Flur",
    "number": "A-101",
    "creator": "М. Иванова",  # which fonts of PDF files lack
    "owner": "図面",
    "document": "m^2, 100% \\U+0041",
}


@pytest.fixture
def scene():
    """A box seen without perspective, on A4 with a title block in what every render writes."""
    scene = box_scene()
    scene.camera.data.type, scene.camera.data.ortho_scale = "ORTHO", 6
    settings = scene.fovea.vectors
    settings.sheet, settings.title_block = "a4", True
    for name, text in SAID.items():
        setattr(settings.titles, name, text)
    return scene


def exported(path, **words):
    words = {"sheet": "a4", "title_block": True} | words
    assert bpy.ops.fovea.export_vectors(filepath=str(path), kind=path.suffix[1:], **words) == {"FINISHED"}
    return path


def said(svg):
    """{name of a cell: what it says} in the title block of an SVG."""
    texts = ElementTree.fromstring(svg).iter(f"{SVG}text")
    return {text.get("id").removeprefix("title-block-"): text.text for text in texts}


def test_an_svg_has_the_texts_of_the_scene_and_its_ids_are_unique(scene, tmp_path):
    svg = exported(tmp_path / "box.svg").read_bytes()
    found = said(svg)
    assert {name: found[name] for name in SAID} == SAID
    assert found["size"] == "A4" and "approver" not in found and found["approver-label"] == "Approved By"
    ids = [element.get("id") for element in ElementTree.fromstring(svg).iter() if element.get("id")]
    assert len(ids) == len(set(ids)) and {"frame", "title-block"} <= set(ids)
    ran(program("xmllint"), "--noout", tmp_path / "box.svg")
    assert svg == exported(tmp_path / "again.svg").read_bytes()


def test_a_pdf_has_the_texts_even_those_that_its_font_lacks(scene, tmp_path):
    reader = program("pdftotext")
    words = " ".join(ran(reader, "-layout", exported(tmp_path / "box.pdf"), "-").split())
    assert [text for text in (*SAID.values(), "Drawing Number", "A4") if text not in words] == []
    assert exported(tmp_path / "again.pdf").read_bytes() == (tmp_path / "box.pdf").read_bytes()


def test_a_dxf_has_the_texts_on_a_layer_and_no_errors(scene, tmp_path):
    path = exported(tmp_path / "box.dxf")
    assert path.read_bytes().isascii() and path.read_bytes() == exported(tmp_path / "again.dxf").read_bytes()
    recover = pytest.importorskip("ezdxf.recover", reason="there is no ezdxf here")
    document, auditor = recover.readfile(path)
    assert not auditor.errors and not auditor.fixes
    texts = document.modelspace().query("TEXT[layer=='TITLE_BLOCK']")
    heights = {text.plain_text(): round(text.dxf.height, 2) for text in texts}
    assert [text for text in SAID.values() if text not in heights] == []
    assert (heights["Küche <Süd> & Flur"], heights["A4"], heights["Title"]) == (3.5, 2.5, 1.8)
    assert {"FRAME", "TITLE_BLOCK"} <= {layer.dxf.name for layer in document.layers}


def test_the_scale_is_that_of_the_drawing_in_meters(scene):
    settings = {"sheet": "a3", "to_scale": True, "title_block": True}
    scene.fovea.drawing_scale = 50
    assert said(api.drawing(**settings))["scale"] == "1:50"
    scene.unit_settings.scale_length = 0.01  # a unit is a centimeter
    assert said(api.drawing(**settings))["scale"] == "2:1"
    scene.camera.data.type = "PERSP"
    assert said(api.drawing(**settings))["scale"] == "not to scale"


def test_scripts_say_other_texts_than_the_scene_and_only_on_sheets(scene):
    found = said(api.drawing(sheet="a5", title_block=True, titles={"title": "Plan"}))
    assert (found["title"], found["number"], found["size"]) == ("Plan", SAID["number"], "A5")
    assert "<text" not in api.drawing(sheet="a5")
    with pytest.raises(ValueError, match="lies on a sheet of paper"):
        api.drawing(title_block=True)
    with pytest.raises(TypeError, match="no 'head'"):
        api.drawing(sheet="a4", title_block=True, titles={"head": "Plan"})


def test_every_render_writes_it_and_files_keep_its_texts(scene, tmp_path):
    scene.fovea.vectors.kind = "SVG"
    expected = exported(tmp_path / "expected.svg").read_bytes()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "box.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "box.blend"))
    bpy.context.scene.render.filepath = str(tmp_path / "still.png")
    bpy.ops.render.render(write_still=True)
    assert (tmp_path / "still_0001.svg").read_bytes() == expected


def test_draw_numbers_the_sheets_of_several_frames_and_cameras(scene, tmp_path):
    blend, words = str(tmp_path / "box.blend"), ["--paper", "a4", "--title-block"]
    bpy.ops.wm.save_as_mainfile(filepath=blend)
    draw.main([blend, *words, "-o", str(tmp_path / "one.svg")])
    assert (tmp_path / "one.svg").read_bytes() == exported(tmp_path / "expected.svg").read_bytes()
    draw.main([blend, *words, "--frames", "4-5", "--cameras", "all", "-o", str(tmp_path / "x_#.svg")])
    assert [said(path.read_bytes())["sheet"] for path in sorted(tmp_path.glob("x_*.svg"))] == ["1/2", "2/2"]
    draw.main([blend, *words, "--frames", "1-2", "--title-field", "sheet=7", "-o", str(tmp_path / "y_#.svg")])
    assert {said(path.read_bytes())["sheet"] for path in tmp_path.glob("y_*.svg")} == {"7"}


def test_for_a_plotter_its_text_is_left_out_in_a_sentence(scene, tmp_path, capfd):
    draw.main(["boxes:1", "--paper", "a4", "--title-field", "title=Plan", "--plotter", "-o", str(tmp_path / "x.svg")])
    assert "fovea notes: The title block has its lines alone" in capfd.readouterr().out
    assert "<text" not in (tmp_path / "x.svg").read_text() and 'id="title-block"' in (tmp_path / "x.svg").read_text()
    assert vectors.remark(vectors.options(plotter=True)) is None


@pytest.mark.parametrize("upright", [False, True])
def test_a_sheet_of_paper_leaves_room_for_it_and_the_drawing_to_scale_fits(scene, upright):
    for sheet, *_ in vectors.sheets():
        asked = {"sheet": sheet, "title_block": True}
        assert bpy.ops.fovea.sheet(upright=upright, **asked) == {"FINISHED"}
        scene.fovea.drawing_scale = 50
        assert said(api.drawing(to_scale=True, **asked))["scale"] == "1:50", sheet
    bpy.ops.fovea.sheet(sheet="a3", title_block=True)
    assert own_style(scene).paper.height_mm == pytest.approx(277 - 30)


def test_the_panel_and_the_export_have_every_field_where_it_is_on():
    fields = [field["name"] for field in native.load().Titles.fields]
    settings, panel = full_scene().fovea.vectors, part("ui.vectors").RENDER_PT_fovea_vectors
    for on in (True, False):
        settings.title_block = on
        shown = [name for owner, name in shown_by(panel).props if owner == settings.titles]
        assert shown == (fields if on else [])
        kind = bpy.ops.fovea.export_vectors.get_rna_type()
        export = SimpleNamespace(layout=RecordingLayout(), bl_rna=kind, title_block=on, chosen_kind=lambda: "pdf")
        part("render.vector_operators").FOVEA_OT_export_vectors.draw(export, bpy.context)
        assert [name for owner, name in export.layout.props if owner == settings.titles] == shown
        assert "title_block" in export.layout.shown
