# SPDX-License-Identifier: GPL-3.0-or-later
"""Hidden lines, haloes and overshoot in pictures, on both backends."""

import bpy
import numpy as np
import pytest
from bpy_extras.object_utils import world_to_camera_view
from mathutils import Vector
from pictures import drawn, ink
from the_addon import (
    add_camera,
    add_hidden,
    box_mesh,
    empty_scene,
    lines_of,
    new_mesh,
    new_object,
    only_lines,
    part,
    use_style,
)

SIZE = (480, 270)  # four reference pixels are one


def only(scene, *names):
    only_lines(scene, *names)


def empty_paper():
    """White paper, an opaque pen 2 px wide, and no hidden lines."""
    scene = empty_scene()
    scene.render.engine, scene.render.resolution_x, scene.render.resolution_y = "FOVEA", *SIZE
    scene.render.dither_intensity = 0.0
    scene.view_settings.view_transform = "Standard"
    fovea = scene.fovea
    fovea.backend, fovea.visibility = "CPU", "EXACT"
    use_style(scene, "plain").line_sets[-1].pen.width = 8
    return scene


def draw_hidden(scene):
    """An opaque hidden pen, 2 px wide."""
    hidden = add_hidden(lines_of(scene))
    hidden.pen.width, hidden.pen.opacity = 8, 1
    return hidden


@pytest.fixture
def box():
    """A box that shows three faces, and the three edges behind it that meet in the corner farthest away."""
    scene = empty_paper()
    new_object(box_mesh(), "Box")
    add_camera()
    far = (-1, 1, -1)
    return scene, [(far, (1, 1, -1)), (far, (-1, -1, -1)), (far, (-1, 1, 1))]


def in_pixels(scene, point):
    bpy.context.view_layer.update()
    x, y, _ = world_to_camera_view(scene, scene.camera, Vector(point))
    return np.array((x * SIZE[0], y * SIZE[1]))


def near(picture, a, b, pixels):
    """(H, W): the pixels within so many of a segment."""
    rows, columns = np.mgrid[: picture.shape[0], : picture.shape[1]] + 0.5
    place, along = np.stack((columns, rows), axis=-1) - a, b - a
    share = np.clip(place @ along / (along @ along), 0, 1)
    return np.linalg.norm(place - share[..., None] * along, axis=-1) < pixels


def along(picture, a, b):
    """Values of a picture on the way from one place to another."""
    x, y = (np.linspace(a, b, 400).T).astype(int)
    return picture[y, x]


@pytest.mark.parametrize("backend", ["CPU", "GPU"])
@pytest.mark.parametrize("visibility", ["EXACT", "ATLAS"])
def test_hidden_edges_are_dashed_and_nothing_else_is_drawn(box, tmp_path, backend, visibility):
    if backend == "GPU" and part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    scene, edges = box
    scene.fovea.backend, scene.fovea.visibility = backend, visibility
    without = ink(drawn(scene, tmp_path / "without.png"))
    draw_hidden(scene)
    added = ink(drawn(scene, tmp_path / "hidden.png")) - without
    assert part("render.session").last_statistics()["backend"] == backend.lower()
    assert added.min() > -0.02, "hidden lines lie below visible ones"
    places = [tuple(in_pixels(scene, end) for end in edge) for edge in edges]
    beside = np.any([near(added, *place, 3) for place in places], axis=0)
    assert np.abs(added[~beside]).max() < 0.02
    for a, b in places:
        inked = along(added, a, b) > 0.5
        dashes = np.count_nonzero(np.diff(inked.astype(int)) == 1)
        period = np.linalg.norm(b - a) / max(dashes, 1)
        assert 0.4 < inked.mean() < 0.85 and 18 < period < 36  # of 24 px


def test_the_hidden_pen_is_another_one(box, tmp_path):
    scene, edges = box
    pen = draw_hidden(scene).pen
    pen.texture, pen.color, pen.opacity = "solid", (1, 0, 0), 0.5
    picture = drawn(scene, tmp_path / "red.png")
    a, b = (in_pixels(scene, end) for end in edges[2])
    red, green = (along(picture[..., channel], a + 0.1 * (b - a), a + 0.9 * (b - a)) for channel in (0, 1))
    assert np.median(red) == 1 and 0.5 < np.median(green) < 0.8


def test_objects_that_are_hidden_altogether_are_drawn(box, tmp_path):
    scene, _ = box
    draw_hidden(scene)
    without = ink(drawn(scene, tmp_path / "without.png"))
    new_object(box_mesh(0.3), "Inside", (0.2, -0.2, 0.1))
    added = ink(drawn(scene, tmp_path / "inside.png")) - without
    for start in np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]):
        for axis in range(3):
            ends = [(0.2, -0.2, 0.1) + 0.3 * start, (0.2, -0.2, 0.1) + 0.3 * start * (1 - 2 * np.eye(3)[axis])]
            assert along(added, *(in_pixels(scene, end) for end in ends)).max() > 0.3
    lines_of(scene).hidden.clear()
    off = ink(drawn(scene, tmp_path / "off.png"))
    bpy.data.objects.remove(bpy.data.objects["Inside"])
    assert np.array_equal(off, ink(drawn(scene, tmp_path / "none.png")))


def card(name, x, y, z, half_width, half_height):
    corners = [(x - half_width, y - half_height, z), (x + half_width, y - half_height, z)]
    corners += [(x + half_width, y + half_height, z), (x - half_width, y + half_height, z)]
    return new_object(new_mesh(corners, [], [(0, 1, 2, 3)], name), name)


def from_above(scene):
    """A camera that sees 16 x 9 units, 30 px each, from above; lines are the borders of cards."""
    camera = add_camera((0, 0, 10), (0, 0, 0))
    camera.rotation_euler, camera.data.type, camera.data.ortho_scale = (0, 0, 0), "ORTHO", 16.0
    only(scene, "border")
    return scene


@pytest.fixture
def stack():
    """Three cards that fill the frame, one above the other; a small card below each: A, B and C at x = -4, 0 and 4."""
    scene = from_above(empty_paper())
    for level in range(3):
        card(f"Cover {level}", 0, 0, -2 * level, 20, 20)
        card("ABC"[level], 4 * level - 4, 0, -2 * level - 1, 1, 1)
    draw_hidden(scene)
    return scene


@pytest.mark.parametrize(
    "backend, visibility", [("CPU", "EXACT"), ("CPU", "ATLAS"), ("GPU", "ATLAS"), ("CPU", "ITEM_BUFFER")]
)
@pytest.mark.parametrize(
    "first, last, shown", [(1, 0, "ABC"), (1, 1, "A"), (2, 2, "B"), (1, 2, "AB"), (3, 0, "C"), (4, 0, "")]
)
def test_a_range_of_hiding_surfaces_is_drawn(stack, tmp_path, backend, visibility, first, last, shown):
    if backend == "GPU" and part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    stack.fovea.backend, stack.fovea.visibility = backend, visibility
    hidden = lines_of(stack).hidden[0]
    hidden.first, hidden.last = first, last
    picture = ink(drawn(stack, tmp_path / "stack.png"))
    found = "".join(name for i, name in enumerate("ABC") if picture[:, 80 + 120 * i : 160 + 120 * i].max() > 0.5)
    assert found == shown


@pytest.fixture
def crossing():
    """An upright card lies over one that goes across; px: the lower one's upper border at row 165, the upper card from
    column 210 to 270."""
    scene = from_above(empty_paper())
    card("Upright", 0, 0, 0, 1, 3)
    card("Across", 0, 0, -1, 6, 1)
    return scene


def border_across(picture):
    """(W,) ink of the lower card's upper border."""
    return picture[163:167].max(axis=0)


def test_a_halo_is_a_gap_before_what_crosses_in_front(crossing, tmp_path):
    without = ink(drawn(crossing, tmp_path / "without.png"))
    lines_of(crossing).halo = 40  # 10 px
    picture = ink(drawn(crossing, tmp_path / "halo.png"))
    before, after = border_across(without), border_across(picture)
    assert before[62:208].min() > 0.9 and before[272:418].min() > 0.9
    assert after[62:196].min() > 0.9 and after[284:418].min() > 0.9
    assert after[203:206].max() < 0.1 and after[274:277].max() < 0.1
    outside = np.ones(SIZE[0], bool)
    outside[190:210] = outside[270:290] = False
    assert np.array_equal(without[:, outside], picture[:, outside]), "nothing else changes"
    lines_of(crossing).halo = 0
    assert np.array_equal(without, ink(drawn(crossing, tmp_path / "again.png")))


def test_overshoot_goes_on_beyond_ends_but_not_behind_what_hides(crossing, tmp_path):
    without = ink(drawn(crossing, tmp_path / "without.png"))
    lines_of(crossing).overshoot = 40  # 10 px
    before, after = border_across(without), border_across(ink(drawn(crossing, tmp_path / "overshoot.png")))
    assert before[40:58].max() < 0.1 and before[422:440].max() < 0.1
    assert after[52:58].min() > 0.9 and after[30:46].max() < 0.1 and after[422:428].min() > 0.9
    assert after[214:266].max() < 0.1, "behind the plate that crosses before it"
    assert np.array_equal(before[62:418], after[62:418])
    lines_of(crossing).overshoot = 0
    assert np.array_equal(without, ink(drawn(crossing, tmp_path / "again.png")))
