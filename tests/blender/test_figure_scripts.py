# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts that draw the pictures of README, the documentation and the gallery, and the one that saves a scene, each
with the smallest input."""

import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import pages
import save_scene
import scenes
import sheet
import thumbnails
import variants
from command.figures import STYLES
from command.pages import DOCS
from picture import pixels


def test_a_thumbnail_is_what_ships_beside_its_style(tmp_path):
    thumbnails.main([str(tmp_path), "plain"])
    drawn, ships = (pixels(folder / "plain.jpg") for folder in (tmp_path, STYLES))
    assert drawn.shape == ships.shape and np.abs(drawn - ships).mean() < 0.02


def test_the_pictures_of_line_thinning_are_of_the_same_boards_with_fewer_lines_far_away(tmp_path):
    thumbnails.thinning(tmp_path)
    for name in ("thinning_off.jpg", "thinning_on.jpg"):
        drawn, ships = (pixels(folder / name) for folder in (tmp_path, STYLES))
        assert drawn.shape == ships.shape and np.abs(drawn - ships).mean() < 0.02
    off, on = (1 - pixels(STYLES / f"thinning_{word}.jpg")[..., 0] for word in ("off", "on"))
    ink = [(off[rows].sum(), on[rows].sum()) for rows in np.array_split(np.arange(len(off)), 4)]
    ratios = [b / a for a, b in ink if a > 50]
    assert ratios == sorted(ratios, reverse=True) and ratios[0] > 3 * ratios[-1], "from near, below, to far away, above"


def test_a_sheet_has_a_tile_for_each_of_its_drawings(tmp_path, monkeypatch):
    tiles = [("with lines", ["--style", "plain"]), ("without", ["--style", "plain", "--without", "lines"])]
    monkeypatch.setitem(variants.variants.SHEETS, "least", ("boxes:2", tiles))
    variants.main(["least", str(tmp_path / "sheet.jpg")])
    lined, empty = np.split(pixels(tmp_path / "sheet.jpg")[..., 0], 2, axis=1)
    picture = slice(sheet.strip((960, 540)), None)
    assert lined.shape == (540 + sheet.strip((960, 540)), 960)
    assert lined[picture].min() < 0.2 and empty[picture].min() > 0.9
    assert all(tile[: picture.start].min() < 0.5 for tile in (lined, empty))  # labels


@pytest.mark.parametrize("name", ["transfers/curve", "lines/border", "way/2_lines", "focus/image", "animation/zoom"])
def test_a_picture_of_the_documentation_has_its_size_and_something_on_it(tmp_path, monkeypatch, name):
    """Stages of the method are shown on boxes, as the demo scene takes seconds."""
    monkeypatch.setattr(pages.scene_source, "open_scene", lambda spec: scenes.build("boxes:2"))
    picture = tmp_path / pages.pages.file_of(name)
    picture.parent.mkdir()
    pages.main([str(tmp_path), name])
    drawn, ships = (pixels(path) for path in (picture, DOCS / pages.pages.file_of(name)))
    assert drawn.shape == ships.shape and np.ptp(drawn[..., :3]) > 0.3


def test_a_saved_scene_opens_ready_to_be_drawn(tmp_path):
    save_scene.main(["boxes:2", "-o", str(tmp_path / "boxes.blend")])
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "boxes.blend"), load_ui=False)
    scene = bpy.context.scene
    assert scene.render.engine == "FOVEA" and scene.camera and "Boxes" in scene.objects
