# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea lines` on shapes whose lines are known."""

import json

import numpy as np
import pytest
from command import lines

from addon import native

CUBE = """v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1
f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"""


@pytest.fixture
def extract_from(tmp_path):
    def from_text(text):
        model = tmp_path / "model.obj"
        model.write_text(text)

        def run(*words):
            options = lines.parse([str(model), "-o", str(tmp_path / "out.npz"), *words])
            return lines.extract(native.load(), options)[0]

        return run

    return from_text


@pytest.fixture
def extract(extract_from):
    return extract_from(CUBE)


def segments(found):
    """Each once, as a sorted pair of points."""
    points, ends = found["points"], found["offsets"][1:] - 1
    starts = np.setdiff1d(np.arange(len(points)), ends)
    return {tuple(sorted((tuple(points[i]), tuple(points[i + 1])))) for i in starts}


def test_the_file_holds_what_it_promises(extract):
    found = extract("--definition", "crease", "--eye", "3,4,5")
    arrays = {name: array for name, array in found.items() if name != "definition"}
    assert {name: array.dtype.kind + str(array.dtype.itemsize) for name, array in arrays.items()} == {
        "points": "f8", "offsets": "i8", "closed": "b1", "path_id": "u8", "strength": "f4"
    }  # fmt: skip
    paths = len(found["closed"])
    assert found["offsets"][0] == 0 and found["offsets"][-1] == len(found["points"]) == len(found["strength"])
    assert len(found["path_id"]) == len(np.unique(found["path_id"])) == len(found["offsets"]) - 1 == paths
    assert str(found["definition"]) == "crease"


def test_a_cube_has_twelve_creases(extract):
    assert len(segments(extract("--definition", "crease", "--eye", "3,4,5"))) == 12
    assert not segments(extract("--definition", "crease", "--param", "angle=91", "--eye", "3,4,5"))


@pytest.mark.parametrize("eye", ["3,4,5", "-3,4,5"])
def test_a_cube_from_a_corner_has_six_contour_edges_in_a_ring(extract, eye):
    found = extract("--definition", "contour", "--eye", eye, "--corner-angle", "180")
    assert len(segments(found)) == 6
    (start, *_), (_, end, *_) = found["offsets"], found["offsets"]
    assert found["closed"].tolist() == [True] and (found["points"][start] == found["points"][end - 1]).all()


def test_the_eye_is_a_point_and_with_ortho_a_direction(extract):
    # So near that three faces are seen in any case; along the axis the far corner does not matter.
    assert len(segments(extract("--definition", "contour", "--eye", "0,0,3"))) == 4
    assert len(segments(extract("--definition", "contour", "--eye", "1.1,1.2,1.3", "--ortho"))) == 6
    assert len(segments(extract("--definition", "contour", "--eye", "0.5,0.5,1.3"))) == 4
    assert len(segments(extract("--definition", "contour", "--eye", "0.5,0.5,1.3", "--ortho"))) == 6


def test_from_inside_there_is_no_contour(extract):
    assert not segments(extract("--definition", "contour", "--eye", "0,0,0"))


def test_an_unknown_definition_is_named(extract):
    with pytest.raises(ValueError, match="no line definition is called 'ridgy'; there are: contour, "):
        extract("--definition", "ridgy", "--eye", "3,4,5")


def test_how_curvature_is_estimated_is_asked_for_and_told(tmp_path):
    n = 16
    x, y = np.meshgrid(np.linspace(-1, 1, n + 1), np.linspace(-1, 1, n + 1))
    points = np.stack([x, y, 0.3 * np.cos(3 * x)], axis=-1).reshape(-1, 3)
    corner = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel() + 1
    quads = np.stack([corner, corner + 1, corner + n + 2, corner + n + 1], axis=-1)
    model = tmp_path / "wave.obj"
    rows = [("v", *point) for point in points.tolist()] + [("f", *quad) for quad in quads.tolist()]
    model.write_text("".join(" ".join(map(str, row)) + "\n" for row in rows))

    def reason(*words, definition="parabolic"):
        file = ["-o", str(tmp_path / "out.npz"), "--definition", definition, "--eye", "0,0,5"]
        return lines.extract(native.load(), lines.parse([str(model), *file, *words]))[2]

    assert reason(definition="border") == "", "borders know nothing of curvature"
    assert "jets" in reason()
    assert reason("--estimator", "one_ring") == "fast (one-rings) as asked for"
    asked = reason("--estimator", "jets", "--degree", "3", "--rings", "2", "--smoothing", "1.5")
    assert asked == "accurate (jets) as asked for, degree 3, radius 2, smoothed over 1.5 edges"
    for wrong in (("--degree", "5"), ("--rings", "99"), ("--smoothing", "-1")):
        with pytest.raises(ValueError, match="wave: "):
            reason(*wrong)


def test_a_cube_from_a_corner_shows_nine_of_its_twelve_edges(extract):
    words = ("--definition", "crease", "--eye", "3,4,5")
    seen = extract(*words, "--visible")
    assert np.all(seen["invisibility"] == 0)
    assert len(rounded(seen)) == 9 and not any((-1, -1, -1) in ends for ends in rounded(seen))
    everything = extract(*words, "--visible", "--hidden")
    assert sum((-1, -1, -1) in ends for ends in rounded(everything)) == 3
    assert len(rounded(everything)) == 12 and np.count_nonzero(everything["invisibility"]) == 3
    assert np.all(np.diff(everything["offsets"]) >= 2) and everything["offsets"][-1] == len(everything["points"])
    assert {len(everything[name]) for name in ("closed", "path_id", "invisibility")} == {12}
    assert {len(everything[name]) for name in ("points", "px", "arc_px", "strength", "kinds")} == {24}


def test_the_lines_of_a_style_are_those_of_its_sets_and_say_what_elision_leaves(extract, tmp_path):
    sets = [{"kinds": {"contour": {}, "crease": {}}, "least_length": 0, "pen": {"spacing": 60}, "hidden": [{}]}]
    file, words = tmp_path / "style.json", ("--eye", "3,4,5", "--visible", "--size", "320x320")
    for enabled in (False, True):
        file.write_text(json.dumps({"schema": 1, "line_sets": sets, "elision": {"enabled": enabled}}))
        found = extract("--style", str(file), *words)
        assert len(rounded(found)) == 12 and np.count_nonzero(found["invisibility"]) == 3
        assert found["shown"].shape == found["invisibility"].shape and np.all(found["shown"] >= 0)
        assert np.all(found["shown"] == 1) != enabled
    with pytest.raises(SystemExit):
        extract("--style", str(file), "--eye", "3,4,5")


def rounded(found):
    """Segments with corners where the model has them."""
    return segments(found | {"points": np.round(found["points"], 4)})


@pytest.mark.parametrize("words, half", [((), None), (("--fov", "40"), np.tan(np.radians(20))), (("--ortho",), None)])
def test_runs_lie_where_they_are_seen(extract, words, half):
    """A pinhole by hand: right, up and back from the eye to the middle of the cube."""
    eye, (width, height) = np.array([3.0, 4.0, 5.0]), (640, 400)
    found = extract("--definition", "crease", "--eye", "3,4,5", "--visible", "--hidden", "--size", "640x400", *words)
    back = eye / np.linalg.norm(eye)
    right = np.cross((1.0, 0.0, 0.0), back)
    right /= np.linalg.norm(right)
    aside, up = found["points"] @ right, found["points"] @ np.cross(back, right)
    if "--ortho" in words:
        half, distance = np.sqrt(3), 1.0
    else:
        half = half or np.sqrt(3 / (eye @ eye - 3))
        distance = np.linalg.norm(eye) - found["points"] @ back
    scale = height / 2 / half / distance
    expected = np.stack([width / 2 + aside * scale, height / 2 + up * scale], -1)
    np.testing.assert_allclose(found["px"], expected, atol=1e-2)
    inner = np.setdiff1d(np.arange(1, len(found["px"])), found["offsets"])
    steps = np.linalg.norm(found["px"][inner] - found["px"][inner - 1], axis=1)
    np.testing.assert_allclose(found["arc_px"][inner] - found["arc_px"][inner - 1], steps, atol=1e-3)
    if "--fov" not in words:
        assert np.all((found["px"] >= 0) & (found["px"] <= (width, height))), "the frame holds the model"


def test_a_run_ends_where_something_hides_it(tmp_path):
    """A square hides the middle of a long edge behind it, as wide as its shadow there."""
    model = tmp_path / "square.obj"
    square = [f"v {x} {y} 0\n" for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    sheet = [f"v {x} {y} -2\n" for x, y in ((-8, 0.2), (8, 0.2), (8, -9), (-8, -9))]
    model.write_text("".join(square + sheet) + "f 1 2 3 4\nf 5 6 7 8\n")
    words = ["--definition", "border", "--eye", "0,0,4", "--visible", "--hidden", "--fov", "150"]
    found = lines.extract(native.load(), lines.parse([str(model), "-o", str(tmp_path / "out.npz"), *words]))[0]
    parts = [found["points"][a:b] for a, b in zip(found["offsets"], found["offsets"][1:])]
    on_edge = [np.allclose(part[:, 1:], (0.2, -2), atol=1e-3) for part in parts]
    (covered,) = [sorted(parts[i][[0, -1], 0]) for i in np.flatnonzero(on_edge & (found["invisibility"] > 0))]
    np.testing.assert_allclose(covered, (-1.5, 1.5), atol=0.01)


@pytest.mark.parametrize("words", [("--hidden",), ("--visible", "--size", "12"), ("--visible", "--fov", "180")])
def test_words_that_make_no_sense_are_named(extract, words, capsys):
    with pytest.raises(SystemExit):
        extract("--definition", "crease", "--eye", "3,4,5", *words)
    assert words[-1] in capsys.readouterr().err


FLOOR = "v -9 -9 -3\nv 9 -9 -3\nv 9 9 -3\nv -9 9 -3\nf 9 10 11 12\n"


@pytest.mark.parametrize("light, perimeter", [(("--sun", "0,0,1"), 8.0), (("--light", "0,0,5"), 16.0)])
def test_a_cube_over_a_floor_casts_a_square(extract_from, light, perimeter):
    found = extract_from(CUBE + FLOOR)("--definition", "cast_shadow", "--eye", "3,4,5", *light)
    assert found["closed"].tolist() == [True]
    assert np.allclose(found["points"][:, 2], -3)
    assert np.linalg.norm(np.diff(found["points"], axis=0), axis=1).sum() == pytest.approx(perimeter, abs=1e-3)


def test_a_floor_is_hatched_in_the_shadow_of_a_cube(extract_from):
    words = "--sun", "0,0,1", "--param", "families=1", "--param", "light=0.5"
    found = extract_from(CUBE + FLOOR)("--definition", "hatching", "--eye", "3,-8,9", *words)
    on_floor = found["points"][np.isclose(found["points"][:, 2], -3)]
    assert len(on_floor) > 20 and np.abs(on_floor[:, :2]).max() == pytest.approx(1, abs=2e-3)


def test_the_light_contour_of_a_cube_is_a_ring_of_six_edges(extract):
    found = extract("--definition", "light_contour", "--eye", "3,4,5", "--sun", "-1,0.5,2")
    assert len(segments(found)) == 6 and found["closed"].tolist() == [True]


@pytest.mark.parametrize("definition", ["cast_shadow", "light_contour"])
def test_without_lights_there_are_no_lines_of_light(extract, definition):
    assert not segments(extract("--definition", definition, "--eye", "3,4,5"))
