# SPDX-License-Identifier: GPL-3.0-or-later
"""Motion blur of lines: what the mean over the shutter is in closed form, and that a frame is a function of the scene
and its number."""

import random

import bpy
import numpy as np
import pytest
from photographs import photograph, with_lines
from pictures import drawn_at, drawn_at_once, scene_from_above
from the_addon import (
    add_camera,
    box_mesh,
    grows,
    lines_of,
    new_mesh,
    new_object,
    only_lines,
    own_style,
    part,
    use_style,
)

animation, motion_blur, session = part("scene.animation"), part("render.motion_blur"), part("render.session")
SIZE, PIXELS, WIDTH = (160, 120), 20, 4  # pixels of a picture, to a unit, of a line
RADIUS, MIDDLE = 40.5, SIZE[0] / 2  # pixels: of the disc; its center at frame 1
FRAMES = range(1, 5)


def blurred(scene, samples=32, shutter=0.5, position="CENTER", on=True):
    """Gives a scene motion blur, and its lines, too, if it is `on`."""
    own_style(scene).animation.motion_blur, own_style(scene).animation.motion_samples = on, samples
    render = scene.render
    render.use_motion_blur, render.motion_blur_shutter, render.motion_blur_position = True, shutter, position


def moves(obj, name, by, index):
    """Animates a vector of an object by so much a frame; at frame 1 it is as it is now."""
    now = getattr(obj, name)[index]
    for frame in (-99, 101):
        getattr(obj, name)[index] = now + by * (frame - 1)
        obj.keyframe_insert(name, index=index, frame=frame)
    for curves in animation.curves(obj):
        for key in (key for curve in curves for key in curve.keyframe_points):
            key.interpolation = "LINEAR"


def flat(points):
    """A polygon in the plane that is looked at; points (P, 2) in pixels."""
    return new_object(new_mesh([(x / PIXELS, y / PIXELS, 0) for x, y in points], [], [tuple(range(len(points)))]))


@pytest.fixture
def disc():
    """A scene of a disc with a border of black ink, from above."""
    scene = scene_from_above(SIZE, PIXELS)
    flat([(RADIUS * np.cos(at), RADIUS * np.sin(at)) for at in np.linspace(0, 2 * np.pi, 256, endpoint=False)])
    style = use_style(scene, "plain")
    only_lines(scene, "border")
    style.elision.enabled = False
    pen = lines_of(scene).pen
    pen.width, pen.color, pen.opacity, pen.texture, pen.taper = WIDTH * 1080 / SIZE[1], (0, 0, 0), 1.0, "solid", 0.0
    return scene


@pytest.fixture
def passes(monkeypatch):
    """passes(scene, frame): {name: (H, W) coverage by ink} of a render, linear."""
    handed = {}

    def keeping(_engine, _layer, filled):
        handed.update({name: pixels[..., 3].copy() for name, (_, pixels) in filled.items() if "Lines" in name})

    monkeypatch.setattr(session, "_hand_over", keeping)

    def render(scene, frame=1):
        scene.frame_set(frame)
        bpy.ops.render.render()
        return handed

    return render


@pytest.fixture
def coverage(passes):
    """coverage(scene, frame): (H, W) of a render's lines."""
    return lambda scene, frame=1: passes(scene, frame)["Lines"]


def swept(at, speed):
    """Coverage of pixels with these centers by a line at 0 that moves by `speed` pixels while the shutter is open."""
    places = np.linspace(-speed / 2, speed / 2, 4001)
    return np.clip(WIDTH / 2 + 0.5 - np.abs(at[:, None] - places), 0, 1).mean(axis=1)


@pytest.mark.parametrize("backend", ["CPU", "GPU"])
def test_a_moving_edge_has_the_profile_of_its_line_swept_over_the_shutter(disc, coverage, backend):
    if backend == "GPU" and part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    disc.fovea.backend = backend
    moves(disc.objects["Object"], "location", 24 / PIXELS, 0)
    blurred(disc, samples=32, shutter=0.5)
    row = coverage(disc)[SIZE[1] // 2]
    columns = np.arange(SIZE[0]) + 0.5
    left = columns < MIDDLE
    for half, edge in ((left, MIDDLE - RADIUS), (~left, MIDDLE + RADIUS)):
        assert np.abs(row[half] - swept(columns[half] - edge, 12)).max() < 4 / 255
    assert row.max() < 0.4


def test_more_samples_converge(disc, coverage):
    moves(disc.objects["Object"], "location", 24 / PIXELS, 0)
    found = {}
    for samples in (2, 8, 32, 128):
        blurred(disc, samples)
        found[samples] = coverage(disc)
    errors = [np.abs(found[samples] - found[128]).max() for samples in (2, 8, 32)]
    assert errors[0] > 4 * errors[1] > 16 * errors[2] > 0 and errors[2] < 0.02


@pytest.mark.parametrize("position, share", [("START", 0.5), ("CENTER", 0.0), ("END", -0.5)])
def test_the_shutter_opens_where_the_scene_says(disc, coverage, position, share):
    def middle():
        found = coverage(disc)
        return (found.sum(axis=0) * np.arange(SIZE[0])).sum() / found.sum()

    moves(disc.objects["Object"], "location", 16 / PIXELS, 0)
    blurred(disc, on=False)
    sharp = middle()
    blurred(disc, samples=8, shutter=0.75, position=position)
    assert middle() - sharp == pytest.approx(share * 0.75 * 16, abs=0.02)


def test_the_curve_of_the_shutter_weights_moments(disc):
    blurred(disc, shutter=1.0, position="START")
    assert motion_blur.moments(disc.render, 4) == [(0.125, 1), (0.375, 1), (0.625, 1), (0.875, 1)]
    curve = disc.render.motion_blur_shutter_curve
    for point, height in zip(curve.curves[0].points, (0.0, 0.0, 1.0)):
        point.location[1], point.handle_type = height, "VECTOR"
    curve.update()
    weights = dict(motion_blur.moments(disc.render, 4))
    assert weights == {0.625: pytest.approx(0.25, abs=0.02), 0.875: pytest.approx(0.75, abs=0.02)}


def test_what_turns_about_the_middle_of_the_shutter_is_symmetric(disc, coverage):
    bpy.data.objects.remove(disc.objects["Object"])
    bar = flat([(-50, -8), (50, -8), (50, 8), (-50, 8)])
    blurred(disc, samples=16)
    still = coverage(disc)
    moves(bar, "rotation_euler", np.radians(40), 2)
    turned = coverage(disc)
    assert np.abs(turned - turned[::-1]).max() < 1 / 255 > np.abs(turned - turned[:, ::-1]).max()
    assert np.abs(turned - still).max() > 0.5


def test_a_scene_that_stands_still_is_drawn_as_without_and_once(disc, coverage, monkeypatch):
    blurred(disc, on=False)
    sharp, drawn = coverage(disc), []
    add = motion_blur.native.load().Exposure.add
    monkeypatch.setattr(motion_blur.native.load().Exposure, "add", lambda *of: drawn.append(of) or add(*of))
    blurred(disc, samples=7)
    assert (coverage(disc) == sharp).all() and len(drawn) == 1


def test_what_stands_still_beside_what_moves_is_as_without(disc, coverage):
    blurred(disc, on=False)
    sharp = coverage(disc)
    moves(flat([(60, -50), (70, -50), (70, -40)]), "location", 0.2, 1)
    blurred(disc, samples=7)
    assert (coverage(disc)[:, : SIZE[0] // 2] == sharp[:, : SIZE[0] // 2]).all()


def test_without_it_in_the_style_or_in_the_scene_no_moment_is_asked(disc, coverage, monkeypatch):
    moves(disc.objects["Object"], "location", 1.2, 0)
    sharp = coverage(disc)
    monkeypatch.setattr(motion_blur, "exposure", lambda *_: pytest.fail("a moment was asked"))
    blurred(disc, on=False)
    assert (coverage(disc) == sharp).all()
    blurred(disc)
    disc.render.use_motion_blur = False
    assert (coverage(disc) == sharp).all()


def test_a_cut_to_another_camera_ends_the_exposure(disc, coverage):
    moves(disc.objects["Object"], "location", 1.2, 0)
    first, other = disc.camera, add_camera((0, 0, 12), (0, 0, 0))
    for frame, camera in ((-10, first), (1, other)):
        disc.timeline_markers.new(f"at {frame}", frame=frame).camera = camera
    blurred(disc, on=False)
    sharp = coverage(disc)
    blurred(disc, position="END")
    assert (coverage(disc) == sharp).all(), "all moments are before the cut"
    blurred(disc)
    half = coverage(disc)
    first.location.x += 1.0
    assert (coverage(disc) == half).all() and (half != sharp).any()


def test_passes_of_line_sets_are_blurred_with_the_lines(disc, passes):
    moves(disc.objects["Object"], "location", 1.2, 0)
    blurred(disc, samples=4)
    disc.view_layers[0].fovea.line_sets = disc.view_layers[0].fovea.line_depth = True
    found = passes(disc)
    of_sets = [found[name] for name in found if name.startswith("Lines_")]
    assert (sum(of_sets) == found["Lines"]).all() and 0 < found["Lines"][SIZE[1] // 2].max() < 0.7


def moving(**settings):
    """A box that grows as it passes before a post, which the camera passes, too; for settings of a style's
    Animation."""
    scene = scene_from_above(SIZE, PIXELS)
    scene.frame_start, scene.frame_end = FRAMES[0], FRAMES[-1]
    add_camera((0, -14, 2), (0, 0, 0))
    new_object(box_mesh(0.5), "Post", (0, 2, 0)).scale.z = 5
    box = new_object(box_mesh(0.5, "Growing"), "Growing", (-1, -2, 0))
    grows(box, 4, -9, 11)
    moves(box, "location", 0.4, 0)
    moves(scene.camera, "location", 0.1, 0)
    use_style(scene, "plain")
    only_lines(scene, "crease", "contour")
    blurred(scene, samples=4)
    for name, value in settings.items():
        setattr(own_style(scene).animation, name, value)
    return scene


@pytest.mark.parametrize("settings", [{}, {"visibility_frames": 1, "hold": 2}], ids=["alone", "over frames, on twos"])
def test_a_frame_is_the_same_alone_in_order_backwards_and_shuffled(tmp_path, settings):
    alone = {frame: drawn_at(moving(**settings), frame, tmp_path) for frame in FRAMES}
    scene = moving(**settings)
    for frame in (*reversed(FRAMES), *random.Random(4).sample(FRAMES, len(FRAMES))):
        assert (drawn_at(scene, frame, tmp_path) == alone[frame]).all(), frame
        assert scene.frame_current == frame and scene.frame_subframe == 0
    for frame, picture in drawn_at_once(scene, FRAMES, tmp_path).items():
        assert (picture == alone[frame]).all(), frame
    assert (alone[1] != alone[3]).any() and (alone[1] == alone[2]).all() == ("hold" in settings)
    own_style(scene).animation.motion_blur = False
    assert np.abs(drawn_at(scene, 3, tmp_path) - alone[3]).max() > 0.1


def test_over_the_render_of_another_engine_lines_are_blurred_as_its_scene_says(tmp_path):
    scene = photograph("CYCLES")
    scene.cycles.samples = 1
    moves(scene.objects["Box"], "location", 1.0, 2)
    bpy.ops.fovea.lines_over()
    sharp = with_lines(scene, tmp_path / "sharp.png")
    own_style(scene).animation.motion_blur = True
    assert (with_lines(scene, tmp_path / "off.png") == sharp).all()
    blurred(scene, samples=8)
    lines = with_lines(scene, tmp_path / "blurred.png")
    left = slice(0, SIZE[0] // 2)
    assert np.abs(lines - sharp)[:, left].max() > 0.5
    assert lines[:, left].sum() == pytest.approx(sharp[:, left].sum(), rel=0.2)
