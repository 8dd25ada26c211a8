# SPDX-License-Identifier: GPL-3.0-or-later
"""Comparing a scene's lines with a drawing, in Blender."""

import bpy
import numpy as np
import pytest
from the_addon import part

comparison, explained_lines = part("comparison"), part("explained_lines")
strengths = part("render.definition_strengths")
SIZE = 320, 240
CUBE = "silhouette", "crease", "image_edge"


@pytest.fixture
def cube():
    """A cube before a camera that sees its front face alone, as a square of 120 pixels in the middle."""
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.mesh.primitive_cube_add()
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.lens = camera.data.sensor_width * 540 / SIZE[0]  # 120 pixels: 2 units, 9 units away
    camera.location, camera.rotation_euler = (0, -10, 0), (np.pi / 2, 0, 0)
    scene = bpy.context.scene
    scene.collection.objects.link(camera)
    scene.camera, scene.render.engine = camera, "FOVEA"
    scene.render.resolution_x, scene.render.resolution_y = SIZE
    return scene


def square():
    x, y, half = SIZE[0] / 2, SIZE[1] / 2, 60
    corners = [(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)]
    return np.array([*corners, corners[0]], np.float32)


def saved(path, px):
    """An NPZ as `fovea lines --visible` writes it, of one line."""
    offsets = np.array([0, len(px)])
    one = {"invisibility": np.zeros(1, np.uint8), "shown": np.ones(1, np.float32)}
    np.savez(path, px=px, offsets=offsets, size=np.array(SIZE), **one)
    return path


def test_the_lines_of_a_scene_are_compared_with_a_drawing_of_it(cube, tmp_path):
    path = saved(tmp_path / "square.npz", square())
    assert bpy.ops.fovea.compare_drawing(filepath=str(path), tolerance=2.0) == {"FINISHED"}
    image = bpy.data.images["Compared with square"]
    assert tuple(image.size) == SIZE
    pixels = np.array(image.pixels[:]).reshape(*SIZE[::-1], 4)[..., :3]
    inked = pixels[pixels.min(axis=2) < 0.9]
    assert len(inked) > 400 and np.ptp(inked, axis=1).max() < 0.01, "all lines are in both, which is gray"


def test_several_drawings_are_compared_with_an_image_of_each(cube, tmp_path):
    saved(tmp_path / "a.npz", square())
    saved(tmp_path / "b.npz", square() + np.float32(0.5))
    chosen = {"directory": str(tmp_path), "files": [{"name": "a.npz"}, {"name": "b.npz"}]}
    assert bpy.ops.fovea.compare_drawing(**chosen, filepath=str(tmp_path / "a.npz"), tolerance=2.0) == {"FINISHED"}
    assert {"Compared with a", "Compared with b"} <= {image.name for image in bpy.data.images}


def test_a_tolerance_in_millimeters_is_of_the_paper(cube, tmp_path, monkeypatch):
    """The frame is 160 mm wide: a drawing 2 pixels beside the scene's lines is 1 mm beside them."""
    path, asked = saved(tmp_path / "moved.npz", square() + np.float32(2.0)), []
    compare = comparison.of_drawings

    def noted(*words):
        asked.append(compare(*words).found)
        return compare(*words)

    monkeypatch.setattr(comparison, "of_drawings", noted)
    how = {"filepath": str(path), "unit": "MILLIMETERS"}
    bpy.ops.fovea.compare_drawing(**how, tolerance=0.6, paper_width=160.0)
    bpy.ops.fovea.compare_drawing(**how, tolerance=1.5, paper_width=160.0)
    assert [found["tolerance_px"] for found in asked] == pytest.approx([1.2, 3.0])
    assert asked[0]["f1"] < 0.2 and asked[1]["f1"] > 0.99
    with pytest.raises(RuntimeError, match="no drawing says it: name its width with Paper Width"):
        bpy.ops.fovea.compare_drawing(**how, tolerance=1.0)


def test_a_drawing_that_is_none_is_refused_in_a_sentence(cube, tmp_path):
    (tmp_path / "a.png").write_bytes(b"no")
    with pytest.raises(RuntimeError, match=r"a\.png: PNG"):
        bpy.ops.fovea.compare_drawing(filepath=str(tmp_path / "a.png"))
    with pytest.raises(RuntimeError, match="could not be registered|has .* pixels"):
        bpy.ops.fovea.compare_drawing(filepath=str(saved_elsewhere(tmp_path)))


def saved_elsewhere(folder):
    one = {"invisibility": np.zeros(1, np.uint8), "shown": np.ones(1, np.float32)}
    np.savez(folder / "b.npz", px=square(), offsets=np.array([0, 5]), size=np.array((100, 50)), **one)
    return folder / "b.npz"


def test_definitions_explain_a_drawing_of_a_cube(cube, tmp_path):
    definitions, outer, contours = strengths.found(bpy.context, SIZE, CUBE, "silhouette", "contour")
    judge = comparison.read(saved(tmp_path / "square.npz", square())).bitmap(SIZE)
    assert outer.measures(judge, 2.0)["f1"] == 1.0
    found = explained_lines.explain(definitions, outer, contours, [judge], 2.0)
    assert found["explained"]["by_lines"] == pytest.approx({"outer": 1.0, "contours": 0.0, "others": 0.0, "none": 0.0})
    assert all(curve["area"] == pytest.approx(1.0) for curve in found["curves"].values())
    assert (cube.render.resolution_x, cube.render.resolution_y) == SIZE
