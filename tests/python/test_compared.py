# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea compare` on files: PNG, SVG and NPZ drawings of known lines, scans, reports, and what explains a drawing."""

import json
import struct
import zlib

import numpy as np
import pytest
from command import compare
from native_core import core

from addon import comparison, comparison_report, explained_lines, paper_scale, registered_drawing, svg_drawing

SIZE = 320, 240
TOLERANCE = 4.0


def ink(lines, size=SIZE):
    """(H, W, 3) picture, bottom row first, of horizontal and vertical lines (x0, y0, x1, y1), 3 pixels wide."""
    picture = np.full((size[1], size[0], 3), 255, np.uint8)
    for x0, y0, x1, y1 in lines:
        picture[y0 - 1 : y1 + 2, x0 - 1 : x1 + 2] = 20
    return picture


def png(path, lines, size=SIZE):
    path.write_bytes(core.png_bytes(ink(lines, size)))
    return path


def svg(path, inside, size=SIZE):
    box = f'viewBox="0 0 {size[0]} {size[1]}" width="{size[0]}" height="{size[1]}"'
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {box}>{inside}</svg>')
    return path


def npz(path, lines, **beside):
    px = np.array(lines, np.float32).reshape(-1, 2)
    offsets = np.arange(0, len(px) + 1, 2)
    arrays = {"invisibility": np.zeros(len(lines), np.uint8), "shown": np.ones(len(lines), np.float32)} | beside
    np.savez(path, px=px, offsets=offsets, size=np.array(SIZE), **arrays)
    return path


def compared(*paths, **how):
    return comparison.of_drawings([comparison.read(path) for path in paths], how.pop("tolerance", TOLERANCE), **how)


LINES = [(40, 60, 280, 60), (100, 60, 100, 200), (200, 60, 200, 200)]


def test_one_drawing_is_the_same_as_png_svg_and_npz(tmp_path):
    as_svg = svg(
        tmp_path / "b.svg",
        '<rect width="320" height="240" fill="white"/><g transform="translate(0,240) scale(1,-1)" fill="none" '
        'stroke="#111"><path d="M40 60H280"/><line x1="100" y1="60" x2="100" y2="200"/>'
        '<polyline points="200,60 200,200"/></g>',
    )
    outlines = svg(tmp_path / "d.svg", '<path d="M40 178h240v4h-240z M98 40h4v140h-4z M198 40h4v140h-4z"/>')
    files = [png(tmp_path / "a.png", LINES), as_svg, npz(tmp_path / "c.npz", LINES), outlines]
    for a in files:
        found = compared(a, *(file for file in files if file != a)).found
        assert found["precision"] == found["recall"] == 1.0, a
        assert found["chamfer_px"] < 1.0 and found["iou"] > 0.9, a


def test_a_line_too_many_costs_precision_and_one_too_few_recall(tmp_path):
    more = png(tmp_path / "more.png", [*LINES, (40, 220, 280, 220)])
    less, exact = png(tmp_path / "less.png", LINES[:2]), npz(tmp_path / "exact.npz", LINES)
    length = 241 + 141 + 141 - 2  # pixels of the three lines
    found = compared(more, exact).found
    assert found["recall"] == 1.0 and found["precision"] == pytest.approx(length / (length + 241), abs=0.01)
    found = compared(less, exact).found
    assert found["precision"] == 1.0 and found["recall"] == pytest.approx((241 + 141 + TOLERANCE) / length, abs=0.01)
    assert compared(more, exact, less).found["recall"] == 1.0


def test_a_synthetic_artist_has_the_precision_and_recall_it_was_given(tmp_path):
    """Of 40 lines 10 % are left out, 5 % invented where nothing is, and all wobble by .3 tolerances."""
    random = np.random.default_rng(3)
    lines = [(20 + 30 * (i % 10), 20 + 50 * (i // 10), 20 + 30 * (i % 10), 50 + 50 * (i // 10)) for i in range(40)]
    invented = [(35, 20 + 50 * i, 35, 50 + 50 * i) for i in range(2)]
    drawn = np.array([line for i, line in enumerate(lines) if i % 10] + invented, float)
    drawn += np.tile(random.normal(0, 0.3 * TOLERANCE, (len(drawn), 2)).clip(-2, 2), 2)
    found = compared(npz(tmp_path / "artist.npz", drawn), npz(tmp_path / "all.npz", lines)).found
    assert found["precision"] == pytest.approx(36 / 38, abs=0.01)
    assert found["recall"] == pytest.approx(0.9, abs=0.01)


def test_hidden_and_thinned_lines_are_not_drawn(tmp_path):
    beside = {"invisibility": np.array([0, 2, 0], np.uint8), "shown": np.array([1, 1, 0], np.float32)}
    found = compared(npz(tmp_path / "a.npz", LINES, **beside), npz(tmp_path / "b.npz", LINES[:1])).found
    assert found["f1"] == 1.0 and found["chamfer_px"] == 0.0


def test_what_an_svg_does_not_show_is_not_drawn(tmp_path):
    shown = '<path d="M10 120h300" stroke="black" fill="none"/>'
    others = (
        '<path d="M10 20h300" stroke="none" fill="none"/><path d="M10 40h300" style="stroke:white;fill:none"/>'
        '<g display="none"><path d="M10 60h300" stroke="black"/></g><defs><path d="M10 80h300" stroke="red"/></defs>'
        '<path class="x" d="M10 90h300"/><style>.x{fill:none;stroke:none}</style>'
    )
    a, b = svg(tmp_path / "a.svg", shown + others), svg(tmp_path / "b.svg", shown)
    assert compared(a, b).found["chamfer_px"] == 0.0
    dark = '<rect width="320" height="240" fill="#123"/><path d="M10 120h300" stroke="white" fill="none"/>'
    assert compared(svg(tmp_path / "dark.svg", dark), b).found["f1"] == 1.0


def test_transforms_of_svg_apply_from_the_outside_in(tmp_path):
    path = '<path transform="rotate(90)" d="M0 0L10 0" stroke="red" fill="none"/>'
    inside = f'<g transform="translate(10 20) scale(2)">{path}</g>'
    found = svg_drawing.read(svg(tmp_path / "a.svg", inside).read_bytes())
    a, b, c, d, e, f = found.transforms[0]
    assert np.allclose([a * 10 + e, b * 10 + f], [10, 40])


def test_bad_files_are_refused_in_a_sentence(tmp_path):
    for name, content, complaint in (
        ("a.png", b"no", "PNG"),
        ("a.svg", b"<svg", "it is no SVG file"),
        ("a.svg", b"<svg xmlns='http://www.w3.org/2000/svg'/>", "its page has no size"),
        ("a.txt", b"", "is no drawing that can be compared"),
    ):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(ValueError, match=complaint):
            comparison.read(tmp_path / name)
    np.savez(tmp_path / "a.npz", px=np.zeros((2, 2)))
    with pytest.raises(ValueError, match="it has no lines in pixels: write it by `fovea lines --visible`"):
        comparison.read(tmp_path / "a.npz")
    whole = npz(tmp_path / "b.npz", LINES).read_bytes()
    middle = len(whole) // 2
    for broken in (b"", whole[:middle], whole[:middle] + bytes(64) + whole[middle + 64 :]):
        (tmp_path / "b.npz").write_bytes(broken)
        with pytest.raises(ValueError, match="b.npz: it is not whole: write it again"):
            comparison.read(tmp_path / "b.npz")
    small, large = png(tmp_path / "s.png", LINES), png(tmp_path / "l.png", LINES, (400, 300))
    with pytest.raises(ValueError, match="s has 320 x 240 pixels and l has 400 x 300 pixels"):
        compared(small, large)


def test_a_drawing_of_nothing_is_no_json_that_others_cannot_read(tmp_path):
    found = compare.finite(compared(png(tmp_path / "a.png", []), npz(tmp_path / "b.npz", LINES)).found)
    assert json.loads(json.dumps(found, allow_nan=False))["chamfer_px"] is None
    assert found["precision"] == 1.0 and found["recall"] == 0.0 and "infinite" in compare.sentence(found)


def asymmetric(size):
    """Boxes in a box: lines of a drawing that looks like itself only one way round."""
    w, h = size
    x, y = (np.array(share) * side for share, side in (([0.15, 0.35, 0.6, 0.85], w), ([0.15, 0.3, 0.55, 0.85], h)))
    (x0, x1, x2, x3), (y0, y1, y2, y3) = x.astype(int), y.astype(int)
    outer = [(x0, y0, x3, y0), (x0, y3, x3, y3), (x0, y0, x0, y3), (x3, y0, x3, y3)]
    return [*outer, (x1, y0, x1, y2), (x1, y2, x3, y2), (x2, y1, x2, y3), (x0, y1, x1, y1)]


def test_a_scan_of_another_size_is_registered_by_its_lines(tmp_path):
    scan = png(tmp_path / "scan.png", asymmetric((500, 400)), (500, 400))
    reference = png(tmp_path / "a.png", asymmetric(SIZE))
    assert compared(reference, scan, register="lines", tolerance=3.0).found["f1"] > 0.98
    other = png(tmp_path / "other.png", [(10, 10 + 20 * i, 200, 10 + 20 * i) for i in range(8)])
    with pytest.raises(ValueError, match="other could not be registered: .*% of the outer boundary"):
        compared(reference, other, register="lines")
    with pytest.raises(ValueError, match="the marks of a prompt sheet are not found"):
        compared(reference, scan, register="marks")


def test_what_a_prompt_sheet_has_printed_is_not_drawn():
    picture = ink(LINES)[..., 0]
    picture[100:103] = 217  # the faint picture
    picture[[0, -1]] = picture[:, [0, -1]] = 150  # the box
    found = registered_drawing._drawn_on_sheet(core.GrayImage(picture)).lines().measures(bitmap(LINES), TOLERANCE)
    assert found["precision"] == found["recall"] == 1.0


def test_a_report_is_one_page_with_an_overlay_for_each_judge(tmp_path):
    a, b, c = (png(tmp_path / f"{name}.png", LINES[:count]) for name, count in (("a<b", 3), ("b", 2), ("c", 1)))
    found = compared(a, b, c)
    comparison_report.write(found, tmp_path / "report.html")
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert text.count("data:image/png;base64,") == 2 and "a&lt;b" in text and "a<b" not in text
    assert "http" not in text
    comparison_report.write(found, tmp_path / "overlay.png")
    colors = core.GrayImage.of_png((tmp_path / "overlay.png").read_bytes()).values
    assert colors.shape == SIZE[::-1] and len(np.unique(colors)) == 3  # white, both, and a alone


def test_an_overlay_tells_which_drawing_has_what(tmp_path):
    found = compared(npz(tmp_path / "a.npz", LINES[:2]), npz(tmp_path / "b.npz", LINES[1:]))
    picture = comparison_report.overlay(found.a, found.judges[0], TOLERANCE)
    assert tuple(picture[150, 100]) == comparison_report.BOTH
    assert tuple(picture[60, 150]) == comparison_report.ONLY_A
    assert tuple(picture[150, 200]) == comparison_report.ONLY_B
    assert tuple(picture[0, 0]) == (255, 255, 255)


def definition(lines, strength, always, in_image=False):
    px = np.array(lines, np.float32).reshape(-1, 2)
    values = np.repeat(np.float32(strength), 2)
    strengths = core.Strengths(px, np.arange(0, len(px) + 1, 2), values, *SIZE)
    return explained_lines.Definition(strengths, always, in_image)


def bitmap(lines):
    px = np.array(lines, np.float32).reshape(-1, 2)
    return core.Bitmap.of_lines(px, np.arange(0, len(px) + 1, 2), *SIZE)


def test_pixels_are_explained_by_the_definitions_near_them():
    """Five lines of 100 pixels: outer boundary, contour, ridge, image edge, and nothing."""
    rows = [(50, y, 149.5, y) for y in (20, 60, 100, 140, 180)]
    outer, contours, judge = bitmap(rows[:1]), bitmap(rows[:2]), bitmap(rows)
    ridge = definition([rows[2], (160, 230, 170, 230)], [0.9, 0.1], contours)
    edge = definition([rows[3], rows[0]], [0.9, 0.9], outer, in_image=True)
    found = explained_lines.explain({"ridge": ridge, "image_edge": edge}, outer, contours, [judge], TOLERANCE)
    explained = found["explained"]
    assert explained["by_lines"] == pytest.approx({"outer": 0.2, "contours": 0.2, "others": 0.2, "none": 0.4})
    assert explained["by_source"] == pytest.approx({"none": 0.2, "surface": 0.4, "image": 0.2, "both": 0.2})
    assert explained["others"] == pytest.approx({"ridge": 0.2})
    assert found["contours"] == [{"precision": 1.0, "recall": pytest.approx(0.4)}]
    recall = np.array(found["curves"]["ridge"]["recall"])
    assert np.all(np.diff(recall) <= 0) and recall[40] == pytest.approx(0.6) and recall[-1] == pytest.approx(0.6)
    assert found["curves"]["ridge"]["area"] == pytest.approx(0.6)


def test_the_best_drawing_has_what_most_judges_agree_on():
    rows = [(50, y, 149.5, y) for y in (20, 80, 140)]
    judges = [bitmap(rows[:2]), bitmap(rows[1:])]
    best = explained_lines.best_curve(judges, TOLERANCE)
    assert [point["precision"] for point in best] == pytest.approx([1.0, 1.0, 2 / 3], abs=0.001)
    assert [point["recall"] for point in best] == pytest.approx([0.0, 0.5, 1.0])


def with_dpi(path, dpi):
    """The PNG with a chunk that says its resolution, as scanners write it."""
    content, data = path.read_bytes(), struct.pack(">IIB", *[round(dpi / 0.0254)] * 2, 1)
    chunk = struct.pack(">I", 9) + b"pHYs" + data + struct.pack(">I", zlib.crc32(b"pHYs" + data))
    path.write_bytes(content[:33] + chunk + content[33:])  # behind the header
    return path


def millimeters(*paths, length=1.0, paper_width=None, **how):
    return compared(*paths, tolerance=paper_scale.Millimeters(length, paper_width), **how).found["tolerance_px"]


def test_a_tolerance_in_millimeters_is_that_of_the_paper_a_png_or_svg_tells_of(tmp_path):
    plain, scan = png(tmp_path / "a.png", LINES), with_dpi(png(tmp_path / "b.png", LINES), 254)
    assert millimeters(plain, scan) == pytest.approx(10.0) == millimeters(scan, plain)
    drawn = '<path d="M40 180H280" stroke="black" fill="none"/>'
    on_page = svg(tmp_path / "c.svg", drawn)
    on_page.write_text(on_page.read_text().replace('width="320" height="240"', 'width="160mm" height="120mm"'))
    assert millimeters(plain, on_page, length=0.5) == pytest.approx(1.0)
    assert millimeters(on_page, on_page) == pytest.approx(6.4)  # 160 mm in the usual 1024 pixels
    assert millimeters(plain, plain, paper_width=64) == pytest.approx(5.0)
    assert millimeters(scan, scan, paper_width=64) == pytest.approx(5.0)
    in_mm = compared(plain, scan, tolerance=paper_scale.Millimeters(0.4)).found
    in_px = compared(plain, scan, tolerance=4.0).found
    assert in_mm["f1"] == in_px["f1"] and in_mm["tolerance_px"] == pytest.approx(4.0) and in_mm["tolerance_mm"] == 0.4
    assert compare.sentence(in_mm).endswith("within 4.00 px, 0.4 mm on paper")


def test_millimeters_on_paper_of_unknown_size_are_refused_in_a_sentence(tmp_path):
    plain, of_screen = png(tmp_path / "a.png", LINES), with_dpi(png(tmp_path / "b.png", LINES), 72)
    for drawings in ((plain, plain), (plain, of_screen), (plain, svg(tmp_path / "c.svg", ""))):
        with pytest.raises(ValueError, match="name its width with --paper-width, save a PNG with its resolution"):
            millimeters(*drawings)
    scan, other = (with_dpi(png(tmp_path / f"{dpi}.png", LINES), dpi) for dpi in (127, 254))
    with pytest.raises(ValueError, match="the paper is 64 mm wide by 127 and 32 mm wide by 254: name its width"):
        millimeters(plain, scan, other)
    for words in (["--tolerance", "1cm"], ["--tolerance", "-1mm"], ["--paper-width", "100"]):
        with pytest.raises(SystemExit):
            compare.parse([str(plain), str(plain), *words])
    asked = compare.parse([str(plain), str(plain), "--tolerance", "1mm", "--paper-width", "190"])
    assert compare.tolerance_of(comparison, asked) == paper_scale.Millimeters(1.0, 190.0)
    assert compare.parse([str(plain), str(plain), "--tolerance", "3px"]).tolerance == 3.0


def test_a_millimeter_on_a_scan_is_as_many_pixels_as_its_registration_makes_of_it(tmp_path):
    scan = with_dpi(png(tmp_path / "scan.png", asymmetric((640, 480)), (640, 480)), 254)
    reference = png(tmp_path / "a.png", asymmetric(SIZE))
    found = compared(reference, scan, register="lines", tolerance=paper_scale.Millimeters(0.5)).found
    assert found["tolerance_px"] == pytest.approx(2.5, rel=0.02) and found["f1"] > 0.98
    drawing = comparison.read(scan)
    assert comparison.tolerance_in([drawing], (640, 480), None, paper_scale.Millimeters(1.0)) == pytest.approx(10.0)
    with pytest.raises(ValueError, match="--paper-width"):
        comparison.tolerance_in([drawing], SIZE, "lines", paper_scale.Millimeters(1.0))


def test_words_that_do_not_go_together_are_refused(tmp_path, capsys):
    a = str(png(tmp_path / "a.png", LINES))
    missing = str(tmp_path / "no.png")
    for words in ([a], [a, a, "--lines", "crease"], [a, a, "-o", "x.pdf"], [a, "--sheet", "a4"], [a, missing]):
        with pytest.raises(SystemExit):
            compare.parse(words)
    assert compare.parse([a, a, "--tolerance", "3", "--json"]).tolerance == 3.0
