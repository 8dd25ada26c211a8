# SPDX-License-Identifier: GPL-3.0-or-later
"""Styles fitted to a drawing: by an artist who draws rows of lines of known strengths, without Blender."""

import json

import numpy as np
import pytest
from command import compare, fit
from native_core import core

from addon import fitted_pens, fitted_style, registered_drawing, style

SIZE = 320, 240
NAMES = "contour", "crease", "ridge", "valley", "suggestive_contour"
PLAIN = style.load("plain")
ROWS = list(dict.fromkeys((*NAMES, *fitted_style.names_of(PLAIN))))
ARTIST = {"contour": 1.0, "crease": 50.0, "ridge": 0.3, "valley": 0.17}


def rows(name):
    """(px, strengths) of 40 short lines of a definition, in rows of its own, from weak to strong."""
    parameter = fitted_style.threshold_of(name)
    default = parameter["default"] if parameter else 1.0
    strengths = default * np.geomspace(0.06, 5.9, 40) if parameter else np.full(40, np.inf)
    number = np.arange(40)
    x, y = 10 + 30 * (number % 10), 10 + 8 * ROWS.index(name) + 50 * (number // 10)
    return np.stack([np.stack([x, y], 1), np.stack([x + 12, y], 1)], 1).astype(np.float32), strengths


def draw(wanted, least=0.0):  # noqa: ARG001 none of them fades
    """(px, offsets) of what a Style draws of all rows: those as strong as its thresholds."""
    drawn = []
    for line_set in wanted.line_sets:
        for name, values in line_set.kinds.items():
            px, strengths = rows(name)
            parameter = fitted_style.threshold_of(name)
            least = values.get(parameter["name"], parameter["default"]) if parameter else 0.0
            drawn.append(px[strengths >= least])
    px = np.concatenate([*drawn, np.empty((0, 2, 2), np.float32)]).reshape(-1, 2)
    return px, np.arange(0, len(px) + 1, 2)


def drawing(thresholds):
    return core.Bitmap.of_lines(*draw(fitted_style.style_with(PLAIN, thresholds)), *SIZE)


def laid(*bitmaps):
    return [registered_drawing.Laid(bitmap) for bitmap in bitmaps]


def fitted(judge, names=NAMES, base=PLAIN, **how):
    return fitted_style.fit(draw, SIZE, names, base, lambda _: laid(judge), 2.0, **how)


def test_an_artists_thresholds_are_found_again():
    found = fitted(drawing(ARTIST))
    assert found.found["f1"] > 0.99 > found.before["f1"]
    assert found.thresholds["contour"] is True and found.thresholds["suggestive_contour"] is None
    for name in ("crease", "ridge", "valley"):
        assert found.thresholds[name] == pytest.approx(ARTIST[name], rel=0.1), name


def test_the_fitted_style_draws_what_was_found_and_nothing_else():
    judge = drawing(ARTIST)
    found = fitted(judge)
    again = style.parse(style.dump(found.style))
    kinds = {name: values for line_set in again.line_sets for name, values in line_set.kinds.items()}
    assert set(kinds) == set(ARTIST)
    assert kinds["ridge"] == {"threshold": pytest.approx(found.thresholds["ridge"]), "prominence": 0.3}
    assert kinds["crease"]["angle"] == pytest.approx(found.thresholds["crease"])
    assert core.Bitmap.of_lines(*draw(again), *SIZE).measures(judge, 2.0)["f1"] == pytest.approx(found.found["f1"])


def test_lines_stay_in_the_line_sets_of_their_style_and_new_ones_go_to_such_of_their_kind():
    made = fitted_style.style_with(PLAIN, {"ridge": 0.4, "apparent_ridge": 0.1, "cast_shadow": 1.0})
    forms, lines = made.line_sets
    assert set(forms.kinds) == {"ridge", "apparent_ridge"} and set(lines.kinds) == {"cast_shadow"}
    assert forms.pen == PLAIN.line_sets[0].pen and lines.kinds["cast_shadow"] == {}


def test_a_style_whose_lines_are_all_as_drawn_stays_as_near_as_it_was():
    own = {"contour": 1.0, "crease": 30.0, "ridge": 0.5, "valley": 0.25, "suggestive_contour": 0.01}
    found = fitted(drawing(own))
    assert found.before["f1"] == 1.0 and found.found["f1"] > 0.99


def test_whoever_wants_it_complete_gets_more_lines_than_whoever_wants_it_clean():
    noise = drawing(ARTIST).pixels.copy()
    noise[:, ::40] = 1  # lines of no definition, across weak and strong ones
    random = np.random.default_rng(2)
    px, _ = rows("ridge")
    for x, y in px[random.random(40) < 0.5][:, 0].astype(int):
        noise[y, x : x + 13] = 0
    judge = core.Bitmap(noise)
    clean, complete = (fitted(judge, beta=beta).found for beta in (0.5, 2.0))
    assert clean["precision"] >= complete["precision"] and clean["recall"] <= complete["recall"]


def test_what_is_nowhere_near_is_refused_in_a_sentence():
    far = np.zeros(SIZE[::-1], np.uint8)
    far[-4:, -9:] = 1
    with pytest.raises(ValueError, match="no lines of the scene are near to the drawing"):
        fitted(core.Bitmap(far))


def test_a_scan_is_registered_to_outlines():
    asked = []

    def judges_of(reference):
        asked.append(reference())
        return laid(drawing(ARTIST))

    fitted_style.fit(draw, SIZE, ("ridge", "crease"), PLAIN, judges_of, 2.0)
    outlines = fitted_style.outlines_of(PLAIN)
    assert asked[0].measures(drawing(dict.fromkeys(outlines, 1.0)), 0.0)["f1"] == 1.0
    assert {"contour", "intersection", "border"} < set(outlines) < set(fitted_style.names_of(PLAIN)) - {"crease"}


def test_definitions_of_the_base_are_fitted_but_those_in_the_image():
    names = fitted_style.names_of(PLAIN)
    assert sorted(names) == sorted({name for line_set in PLAIN.line_sets for name in line_set.kinds})
    in_image = fitted_style.style_with(PLAIN, {"crease": 30.0, "image_edge": 1.0})
    assert fitted_style.names_of(in_image) == ["crease"]


def test_words_and_figures_of_the_command(tmp_path, capsys):
    (tmp_path / "a.png").write_bytes(b"")
    words = ["office", str(tmp_path / "a.png"), "-o", str(tmp_path / "a.json")]
    assert fit.parse(words).style == "plain" and fit.parse([*words, "--beta", "2"]).beta == 2.0
    for wrong, told in (
        ([*words[:3], "a.png"], "a style is a .json"),
        ([*words, "--beta", "3"], "times the weight of precision from 0.5 to 2"),
        (["office", "b.png", *words[2:]], "there is no file b.png"),
        (["no.blend", *words[1:]], "there is no file no.blend"),
    ):
        with pytest.raises(SystemExit):
            fit.parse(wrong)
        assert told in capsys.readouterr().err
    with pytest.raises(SystemExit):
        compare.parse([str(tmp_path / "a.png"), str(tmp_path / "a.png"), "--scene", "no.blend"])
    assert "there is no file no.blend" in capsys.readouterr().err
    measures = {"precision": 1.0, "recall": 0.5, "f1": 2 / 3}
    found = measures | {"before": measures, "tolerance_px": 2.0, "style": "a.json", "cross_validated_f1": 0.6}
    found |= {"thresholds": {"contour": True, "crease": 47.25, "ridge": None}, "judged_by": [{"name": "a"} | measures]}
    found |= {"pens": [{"name": "lines", "width": 2.5, "darkness": 0.8}, {"name": "a", "width": 1.5, "darkness": None}]}
    hand = {"name": "lines", "overshoot": 6.25, "wobble": 1.5, "wobble_length": 61.2}
    other = {"name": "a", "overshoot": None, "wobble": 0.0, "wobble_length": None}
    found["hands"] = [hand, other, other | {"overshoot": 0.0}]
    text = fit.told(found).splitlines()
    assert text[1] == "F1 0.600 of parts of the drawing that were held out of the fit"
    assert [line.split()[-1] for line in text[2:5]] == ["on", "47.25", "off"]
    assert [line.split() for line in text[5:]] == [
        "pen of lines 2.50 px wide, 80% dark".split(), "pen of a 1.50 px wide".split(),
        "hand of lines overshoot 6.2 px, wobble 1.5 px in waves of 61 px".split(),
        "hand of a overshoot unknown, no wobble".split(), "hand of a no overshoot, no wobble".split(), ["a.json"]
    ]  # fmt: skip
    text = fit.told(found | {"judged_by": [{"name": name} | measures for name in "ab"]}).splitlines()
    assert text[2].split() == "b precision 1.000, recall 0.500, F1 0.667".split()
    assert text[3] == "F1 0.600 of drawings that were held out of the fit"
    assert len(fit.parse([*words[:2], *words[1:]]).drawings) == 2
    json.dumps(found, allow_nan=False)


def test_a_style_is_fitted_to_the_drawings_of_several_artists():
    """One draws creases from 50 degrees on, the other from 100 on, and both are told how near the style is to each."""
    sparing = ARTIST | {"crease": 100.0}
    judges = [drawing(ARTIST), drawing(sparing)]
    found = fitted_style.fit(draw, SIZE, NAMES, PLAIN, lambda _: laid(*judges), 2.0)
    assert found.thresholds["contour"] is True and found.thresholds["suggestive_contour"] is None
    for name in ("ridge", "valley"):
        assert found.thresholds[name] == pytest.approx(ARTIST[name], rel=0.1), name
    assert 45 < found.thresholds["crease"] < 110
    drawn = core.Bitmap.of_lines(*draw(found.style), *SIZE)
    for judge, of in zip(judges, found.of_each):
        assert of["f1"] == pytest.approx(drawn.measures(judge, 2.0)["f1"], abs=0.002)
    alone, crossed = fitted(judges[0]), found.held_out["f1"]
    of_other = core.Bitmap.of_lines(*draw(alone.style), *SIZE).measures(judges[1], 2.0)["f1"]
    assert of_other - 0.02 < crossed < 1.0, "each is drawn by the thresholds of the other"
    assert alone.held_out["f1"] > 0.97, "an artist who keeps to thresholds is told in parts that were held out"


def picture(strokes):
    """The Laid of a picture of [(px (N, 2, 2) of level lines, width [px], light of the ink)] on white
    paper: a pixel's light is that of the parts that are drawn."""
    light = np.ones(SIZE[::-1])
    for px, width, ink in strokes:
        for (x0, y), (x1, _) in px:
            rows = np.arange(SIZE[1])
            share = np.clip(np.minimum(rows + 1, y + width / 2) - np.maximum(rows, y - width / 2), 0, 1)[:, None]
            light[:, int(x0) : int(x1)] *= 1 - share * (1 - ink)
    values = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    gray = core.GrayImage(np.rint(255 * values).astype(np.uint8))
    return registered_drawing.Laid(gray.lines(), gray)


def lines_at(rows, x0=20, x1=300):
    return np.array([[(x0, y), (x1, y)] for y in rows], np.float32)


def bitmap(px):
    return core.Bitmap.of_lines(px.reshape(-1, 2), np.arange(0, 2 * len(px) + 1, 2), *SIZE)


def test_pens_are_as_wide_and_dark_as_the_strokes_near_their_lines():
    """Rows lie at all parts of a pixel, as lines of drawings do."""
    forms, lines = lines_at(np.arange(10, 120, 10.3)), lines_at(np.arange(130, 235, 10.3))
    drawn = picture([(forms, 1.5, 0.4), (lines, 3.2, 0.1)])
    looks = fitted_pens.looked(["forms", "lines"], [bitmap(forms), bitmap(lines)], [drawn], 2.0)
    assert [look.name for look in looks] == ["forms", "lines"]
    assert looks[0].width == pytest.approx(1.5, rel=0.1) and looks[0].darkness == pytest.approx(0.6, rel=0.1)
    assert looks[1].width == pytest.approx(3.2, rel=0.05) and looks[1].darkness == pytest.approx(0.9, rel=0.05)
    made = fitted_pens.with_looks(PLAIN, looks, SIZE[1])
    assert made.line_sets[1].pen.width == pytest.approx(3.2 * 1080 / SIZE[1], rel=0.05)
    assert made.line_sets[1].pen.opacity == pytest.approx(0.9, rel=0.05) and made.line_sets[1].pen.color == (0, 0, 0)
    assert made.line_sets[0].pen == PLAIN.line_sets[0].pen.replace(
        width=made.line_sets[0].pen.width, opacity=made.line_sets[0].pen.opacity
    )


@pytest.mark.parametrize("unit, width", [("pixels", 4.0), ("millimetres", 4.0 * 210 / 240), ("reference", 18.0)])
def test_pens_keep_the_unit_of_their_width(unit, width):
    pen = style.Pen(width_unit=unit, color=(0.5, 0.5, 0.5))
    base = PLAIN.replace(line_sets=(PLAIN.line_sets[0].replace(pen=pen),))
    found = fitted_pens.with_looks(base, [fitted_pens.Looked("forms", 4.0, 0.25)], 240).line_sets[0].pen
    assert found.width == pytest.approx(width, rel=1e-3) and found.width_unit == unit
    assert found.opacity == pytest.approx(0.5) and found.color == (0.5, 0.5, 0.5)
    darker = fitted_pens.with_looks(base, [fitted_pens.Looked("forms", 4.0, 0.75)], 240).line_sets[0].pen
    assert darker.opacity == 1 and darker.color == pytest.approx((0.25, 0.25, 0.25))
    on_dark = fitted_pens.with_looks(base, [fitted_pens.Looked("forms", 4.0, None)], 240).line_sets[0].pen
    assert on_dark == pen.replace(width=found.width)


def test_strokes_that_are_too_thin_or_too_few_leave_pens_as_they_are():
    rows = lines_at(np.arange(10, 230, 10.3))
    assert fitted_pens.looked(["a"], [bitmap(rows)], [picture([(rows, 0.8, 0.0)])], 2.0) == [None]
    short = lines_at([40, 60], 20, 40)
    assert fitted_pens.looked(["a"], [bitmap(short)], [picture([(short, 4.0, 0.0)])], 2.0) == [None]
    assert fitted_pens.looked(["a"], [bitmap(rows)], [], 2.0) == [None]
    assert fitted_pens.with_looks(PLAIN, [None, None], SIZE[1]) == PLAIN


def test_strokes_of_a_scan_are_measured_there_and_are_as_wide_as_in_the_frame():
    """A scan of twice the frame's size, turned: what is narrow in the frame has its width there."""
    rows = lines_at(np.arange(10, 230, 10.3))
    drawn = picture([(rows, 3.0, 0.2)])
    to_scan = np.linalg.inv([[0.4, -0.03, 60.0], [0.03, 0.4, 40.0], [1e-5, 0, 1]])
    of_frame = np.linalg.inv(to_scan) @ np.array([*rows.reshape(-1, 2).T, np.ones(2 * len(rows))])
    lines = bitmap((of_frame[:2] / of_frame[2]).T.astype(np.float32).reshape(-1, 2, 2))
    asked = registered_drawing.Laid(lines, drawn.gray, None, to_scan, drawn.gray)
    (look,) = fitted_pens.looked(["a"], [lines], [asked], 2.0)
    assert look.width == pytest.approx(1.2, rel=0.05) and look.darkness == pytest.approx(0.8, rel=0.05)


def test_a_fit_to_a_picture_gives_the_style_its_strokes():
    px = draw(fitted_style.style_with(PLAIN, ARTIST))[0].reshape(-1, 2, 2)
    # At all parts of a pixel, as lines of drawings are.
    asked = [picture([(px + np.linspace(0, 1, len(px))[:, None, None] * (0, 1), 2.4, 0.0)])]
    found = fitted_style.fit(draw, SIZE, NAMES, PLAIN, lambda _: asked, 2.0)
    assert {look.name for look in found.looks} == {"forms", "lines"}
    for look, line_set in zip(found.looks, found.style.line_sets):
        assert look.width == pytest.approx(2.4, rel=0.1) and line_set.pen.width == pytest.approx(
            4.5 * look.width, rel=1e-3
        )
    kept = fitted_style.fit(draw, SIZE, NAMES, PLAIN, lambda _: asked, 2.0, pens=False)
    assert kept.looks == [] and kept.thresholds == found.thresholds
    assert [s.pen for s in kept.style.line_sets] == [s.pen for s in PLAIN.line_sets]


def test_hidden_lines_and_line_thinning_are_left_out_of_the_fit_and_stay_in_the_style():
    sets = tuple(line_set.replace(hidden=(style.Hidden(),)) for line_set in PLAIN.line_sets)
    base, seen = PLAIN.replace(line_sets=sets, elision=style.Elision(enabled=True)), []

    def drawn(wanted, least):
        seen.append(wanted)
        return draw(wanted, least)

    found = fitted_style.fit(drawn, SIZE, ("contour", "ridge"), base, lambda _: laid(drawing({"ridge": 0.3})), 2.0)
    assert not any(wanted.elision.enabled or line_set.hidden for wanted in seen for line_set in wanted.line_sets)
    assert found.style.elision.enabled and found.style.line_sets[0].hidden == sets[0].hidden
    assert found.drawings == len(seen)


def test_every_definition_that_has_a_least_strength_has_a_threshold():
    named = {name: fitted_style.threshold_of(name) for name in fitted_style.catalogue.by_name()}
    assert named["crease"]["name"] == "angle" and named["image_edge"]["name"] == "threshold"
    assert {name for name, threshold in named.items() if threshold is None} >= {"contour", "section_hatch", "isophote"}
