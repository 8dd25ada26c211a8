# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings as vectors, written from Blender: read back by other parsers, and beside the picture of the same scene."""

import re
import sys
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path

import bpy
import golden_scenes
import numpy as np
import pytest
from pictures import box_scene
from the_addon import part, use_style

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import draw

vectors = part("render.vectors")

SVG, INKSCAPE = "{http://www.w3.org/2000/svg}", "{http://www.inkscape.org/namespaces/inkscape}"


@pytest.fixture
def scene():
    scene = box_scene()
    style = use_style(scene, "plain")
    style.elision.enabled = False
    return scene


def exported(path, **words):
    assert bpy.ops.fovea.export_vectors(filepath=str(path), kind=path.suffix[1:], **words) == {"FINISHED"}
    return path.read_bytes()


def points(path):
    """Ends of the segments of an SVG path's data, which is of relative lines and cubics."""
    at, start, found = np.zeros(2), np.zeros(2), []
    for letter, numbers in re.findall(r"([a-zA-Z])([^a-zA-Z]*)", path.get("d")):
        values = np.array([float(n) for n in re.findall(r"-?(?:\d+\.?\d*|\.\d+)", numbers)])
        if letter in "hv":
            values = np.insert(values.reshape(-1, 1), 1 if letter == "h" else 0, 0.0, axis=1)
        values = values.reshape(-1, 2)
        if letter == "z":
            at = start
        for value in values[2::3] if letter == "c" else values:
            at = value if letter == "M" else at + value
            start = at if letter in "Mm" else start
            found.append(at)
    return np.array(found)


def traced(path):
    """(n, 2) points along an SVG path's curves: ends of lines, and of cubics, with points as dense as they bend."""
    at, found = np.zeros(2), []
    for letter, numbers in re.findall(r"([a-zA-Z])([^a-zA-Z]*)", path.get("d")):
        values = [float(n) for n in re.findall(r"-?(?:\d+\.?\d*|\.\d+)", numbers)]
        if letter == "z":
            found.append(found[0])
        elif letter == "c":
            for a, b, end in np.reshape(values, (-1, 3, 2)):
                length = np.hypot(*a) + np.hypot(*(b - a)) + np.hypot(*(end - b))
                u = np.linspace(0, 1, 3 + int(12 * np.sqrt(length)))[1:, None]
                found.extend(at + 3 * u * (1 - u) ** 2 * a + 3 * u**2 * (1 - u) * b + u**3 * end)
                at = found[-1]
        else:
            along = {"h": lambda v: (v, 0.0), "v": lambda v: (0.0, v)}
            for step in [along[letter](v) for v in values] if letter in along else np.reshape(values, (-1, 2)):
                at = np.array(step) if letter == "M" else at + step
                found.append(at)
    return np.array(found)


def farthest(points, line):
    """How far points are at most from a polyline that goes on straight beyond its ends."""
    start, side = line[:-1], np.diff(line, axis=0)
    share = ((points[:, None] - start) * side).sum(axis=2) / np.maximum((side**2).sum(axis=1), 1e-20)
    low, high = np.zeros(len(side)), np.ones(len(side))
    low[0], high[-1] = -np.inf, np.inf
    nearest = start + np.clip(share, low, high)[..., None] * side
    return np.hypot(*(points[:, None] - nearest).T).min(axis=0).max()


@pytest.mark.parametrize("name", golden_scenes.SCENES)
def test_curves_of_golden_scenes_keep_their_tolerance_on_both_sides(name, monkeypatch):
    model = golden_scenes.MODELS.get(name)
    if model and not model.exists():
        pytest.skip(f"there is no {model}")
    golden_scenes.build(name)
    bpy.context.scene.render.engine = "FOVEA"
    tolerance, made, files = 0.02, vectors.made, []

    def both(frame, kind, asked):
        for tried in (0.0, tolerance):
            words = {"sheet": "a4", "widths": "center", "ground": False, "tolerance": tried}
            files.append(made(frame, kind, vectors.options(**words)).file())
        return made(frame, kind, asked)

    monkeypatch.setattr(vectors, "made", both)
    vectors.drawing(bpy.context, "svg", vectors.options(ground=False))
    lines, curves = ({p.get("id"): p for p in ElementTree.fromstring(file).iter(f"{SVG}path")} for file in files)
    lines.pop("section-fill", None), curves.pop("section-fill", None)
    off, shared = [], sorted(lines.keys() & curves.keys())
    shared = shared[:: 1 + len(shared) // 300]  # of very many, some
    for line, curve in ((traced(lines[key]), traced(curves[key])) for key in shared):
        # Where strokes fade, and dashes have just divided, the last point that is seen is another one of finer lines.
        if np.abs(line[[0, -1]] - curve[[0, -1]]).max() < 2 * tolerance:
            off.append(max(farthest(line, curve), farthest(curve, line)))
    assert len(off) > 0.9 * len(shared) > 5 and len(off) > 0.02 * len(lines)
    assert np.quantile(off, 0.95) < 1.1 * tolerance + 0.002  # files have micrometers
    assert max(off) < 2.5 * tolerance  # lines of small pictures have zigzags, which are smoothed before


def test_a_box_is_its_edges_in_layers_on_paper(scene, tmp_path):
    root = ElementTree.fromstring(exported(tmp_path / "box.svg", sheet="a4"))
    assert (root.get("width"), root.get("height"), root.get("viewBox")) == ("297mm", "210mm", "0 0 297 210")
    layers = [g.get(f"{INKSCAPE}label") for g in root.iter(f"{SVG}g")]
    assert layers[0] == "%paper" and layers[-1] == "visible" and {"2 lines"} <= set(layers)
    paths = list(root.iter(f"{SVG}path"))
    assert {path.get("data-object") for path in paths} == {"Box"}
    assert len({path.get("id") for path in paths}) == len(paths) > 3
    for path in paths:
        at = points(path)
        assert np.all(at >= 9.9) and np.all(at <= [287.1, 200.1])


def test_files_are_the_same_twice_and_the_operator_writes_what_draw_does(scene, tmp_path):
    for kind in ("svg", "pdf", "dxf"):
        first = exported(tmp_path / f"a.{kind}")
        assert first == exported(tmp_path / f"b.{kind}") and len(first) > 500
    blend = tmp_path / "box.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(blend))
    draw.main([str(blend), "-o", str(tmp_path / "c.svg")])
    assert (tmp_path / "c.svg").read_bytes() == (tmp_path / "a.svg").read_bytes()


def test_a_pdf_has_a_page_of_compressed_paths_and_a_layer_for_each_set(scene, tmp_path):
    pdf = exported(tmp_path / "box.pdf", sheet="a5")
    assert pdf.startswith(b"%PDF-1.5") and pdf.endswith(b"%%EOF\n")
    assert re.search(rb"/MediaBox \[ 0 0 595\.\d+ 419\.\d+ \]", pdf)
    start = int(re.search(rb"startxref\n(\d+)", pdf)[1])
    places = [int(place) for place in re.findall(rb"(\d{10}) 00000 n", pdf[start:])]
    assert [pdf[place:].split(b" ", 1)[0] for place in places] == [b"%d" % (i + 1) for i in range(len(places))]
    stream = re.search(rb"4 0 obj\n<< /Filter /FlateDecode /Length (\d+) >>\nstream\n", pdf)
    content = zlib.decompress(pdf[stream.end() : stream.end() + int(stream[1])]).decode()
    assert content.count("BDC") == content.count("EMC") == pdf.count(b"/Type /OCG")
    assert len(re.findall(r"^[^\n]* m [^\n]*\n[Sf]$", content, re.M)) > 3


def test_for_a_plotter_the_pen_moves_little_between_lines(scene, tmp_path):
    drawn = vectors.drawing(bpy.context, "svg", vectors.options(plotter=True, sheet="a4"))
    figures = drawn.figures
    assert figures["lifts"] == figures["paths"] > 0
    assert figures["pen_up_mm"] <= 1.1 * figures["pen_up_nearest_mm"]
    root = ElementTree.fromstring(drawn.file())
    ends = [points(path) for path in root.iter(f"{SVG}path")]
    assert len(ends) == figures["paths"]
    assert not list(root.iter(f"{SVG}rect"))


@pytest.mark.parametrize("name", ["boxes_10", "suzanne_2", "orthographic", "crank_arm", "rocker_arm"])
def test_of_golden_scenes_a_plotter_lifts_its_pen_over_two_fifths_of_the_way_that_strokes_are_found_in(name):
    model = golden_scenes.MODELS.get(name)
    if model and not model.exists():
        pytest.skip(f"there is no {model}")
    golden_scenes.build(name)
    bpy.context.scene.render.engine = "FOVEA"
    figures = vectors.drawing(bpy.context, "svg", vectors.options(plotter=True)).figures
    assert figures["lifts"] > 25
    assert figures["pen_up_mm"] <= 0.4 * figures["pen_up_unordered_mm"]
    assert figures["pen_up_mm"] <= figures["pen_up_nearest_mm"]


def test_the_name_of_the_file_says_its_kind_unless_another_is_asked_for(scene, tmp_path):
    def written(name, **words):
        bpy.ops.fovea.export_vectors(filepath=str(tmp_path / name), **words)
        return (tmp_path / name).read_bytes()

    assert written("a.pdf").startswith(b"%PDF")
    assert written("a.DXF").lstrip().startswith(b"0\nSECTION")
    assert written("a").startswith(b"<?xml") and written("b.pdf", kind="svg").startswith(b"<?xml")


def test_a_drawing_that_is_stopped_is_told_in_a_sentence(scene, tmp_path, monkeypatch):
    blend = tmp_path / "box.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(blend))
    monkeypatch.setattr(draw.vectors, "drawing", lambda *_words, **_more: None)
    with pytest.raises(RuntimeError, match="c.svg: stopped before the lines were drawn"):
        draw.main([str(blend), "-o", str(tmp_path / "c.svg")])
    assert not (tmp_path / "c.svg").exists()


def test_kinds_are_there_as_soon_as_the_native_module_is(monkeypatch):
    monkeypatch.setattr(vectors, "_kept", {})
    with monkeypatch.context() as without:
        without.setattr(vectors, "choices", lambda _of: [])
        assert vectors.kept_items("KINDS") == []
    assert [name for name, *_ in vectors.kept_items("KINDS")] == ["svg", "pdf", "dxf", "ora", "png"]


def test_nothing_is_left_where_a_file_cannot_be_written(scene, tmp_path):
    with pytest.raises(RuntimeError, match="could not be written"):
        exported(tmp_path / "none" / "box.svg")
    with pytest.raises(RuntimeError, match="leaves no room"):
        exported(tmp_path / "box.svg", sheet="a5", margin=80.0)
    scene.camera = None
    assert not bpy.ops.fovea.export_vectors.poll()
    assert not list(tmp_path.iterdir())
