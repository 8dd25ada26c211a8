# SPDX-License-Identifier: GPL-3.0-or-later
"""Final drawings match their references, and the comparison detects differences."""

import os
import shutil
from pathlib import Path

import golden
import golden_scenes
import numpy as np
import pytest
from golden_report import Report
from pictures import pixels_of
from the_addon import add_camera, empty_scene, mark_edges, new_mesh, new_object

REFERENCES = golden_scenes.PROJECT / "tests" / "references"


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    folder = os.environ.get("FOVEA_REPORTS")
    return Report(Path(folder or tmp_path_factory.mktemp("reports")) / "golden")


@pytest.mark.parametrize("name", golden_scenes.SCENES)
def test_a_drawing_is_as_its_reference(name, report, pytestconfig):
    model = golden_scenes.MODELS.get(name)
    if model and not model.exists():
        pytest.skip(f"there is no {model}")
    golden_scenes.build(name)
    golden_scenes.draw(report.new(name))
    reference = REFERENCES / f"{name}.png"
    renewed = pytestconfig.getoption("update_references") and renew(reference, report.new(name))
    assert reference.exists(), f"there is no {reference}; --update-references makes it"
    result = compare_files(reference, report.new(name))
    report.add(name, reference, result, renewed)
    assert result.passed, f"{name}: {result}; {report.page} shows it"


def compare_files(reference, new):
    return golden.compare(pixels_of(reference), pixels_of(new))


def renew(reference, new):
    """References that still pass are kept: both Blenders are held against the same ones."""
    if reference.exists() and compare_files(reference, new).passed:
        return False
    reference.parent.mkdir(exist_ok=True)
    shutil.copyfile(new, reference)
    return True


def test_every_reference_has_a_scene_and_together_they_are_small():
    references = list(REFERENCES.glob("*"))
    assert {file.stem for file in references} <= set(golden_scenes.SCENES)
    assert sum(file.stat().st_size for file in references) < 5 << 18


@pytest.fixture(params=golden_scenes.SCENES)
def reference(request):
    return pixels_of(REFERENCES / f"{request.param}.png")


def squares(picture, count=10, size=12):
    """Rows and columns of squares that have the ink of a line in them, spread over the picture."""
    paper = np.median(picture.reshape(-1, 4), axis=0)
    ink = np.abs(picture - paper).max(axis=2)
    inked = np.argwhere(ink[20:-20, 20:-20] > 0.5 * ink.max()) + 20
    for row, column in inked[:: max(len(inked) // count, 1)]:
        yield slice(row - size // 2, row + size // 2), slice(column - size // 2, column + size // 2)


def test_one_level_of_rounding_passes(reference):
    noise = np.random.default_rng(1).integers(-1, 2, reference.shape) / 255
    assert golden.compare(reference, np.clip(reference + noise, 0, 1).astype(np.float32)).passed


def test_a_piece_of_a_line_that_is_missing_or_new_fails(reference):
    paper = np.median(reference.reshape(-1, 4), axis=0)
    for rows, columns in squares(reference):
        without = reference.copy()
        without[rows, columns] = paper
        assert not golden.compare(reference, without).passed
        assert not golden.compare(without, reference).passed


def test_a_piece_of_a_line_that_is_moved_by_two_pixels_fails(reference):
    for rows, columns in squares(reference):
        moved = [reference.copy(), reference.copy()]
        for axis, picture in enumerate(moved):
            picture[rows, columns] = np.roll(reference, 2, axis=axis)[rows, columns]
        # Along itself a line can be moved without a trace.
        assert not all(golden.compare(reference, picture).passed for picture in moved)


def test_other_ink_or_paper_or_size_fails(reference):
    paper = np.median(reference.reshape(-1, 4), axis=0)
    assert not golden.compare(reference, paper + 0.9 * (reference - paper)).passed
    assert not golden.compare(reference, reference * np.float32((0.97, 1, 1, 0.97))).passed
    assert not golden.compare(reference, reference[1:]).passed


def ruled_card(left_out=None, moved_px=0.0):
    """A card before a parallel camera with nine marked lines across it, 60 px long and 10 px apart."""
    empty_scene()
    scale = 1 / golden_scenes.WIDTH  # of a pixel, where the frame is one unit wide
    heights = [10.0 * row for row in range(11)]
    heights[5] += moved_px
    vertices = [(x * scale, y * scale, 0) for y in heights for x in (0, 60)]
    card = new_mesh(vertices, [], [(i, i + 1, i + 3, i + 2) for i in range(0, 20, 2)])
    across = [e.index for e in card.edges if abs(e.vertices[0] - e.vertices[1]) == 1 and 0 < e.vertices[0] < 20]
    mark_edges(card, freestyle=[edge for number, edge in enumerate(across) if number != left_out])
    new_object(card, "Card")
    camera = add_camera((0.06, 0.1, 1), (0.06, 0.1, 0))
    camera.data.type, camera.data.ortho_scale, camera.rotation_euler = "ORTHO", 1.0, (0, 0, 0)
    golden_scenes.frame()


@pytest.mark.parametrize(
    "change, passes",
    [({}, True), ({"moved_px": 0.02}, True), ({"moved_px": 2.0}, False), ({"left_out": 4}, False)],
    ids=["same", "hardly moved", "moved by two pixels", "left out"],
)
def test_one_line_of_a_drawing(change, passes, tmp_path):
    for name, card in (("before", {}), ("after", change)):
        ruled_card(**card)
        golden_scenes.draw(tmp_path / f"{name}.png")
    assert compare_files(tmp_path / "before.png", tmp_path / "after.png").passed == passes
