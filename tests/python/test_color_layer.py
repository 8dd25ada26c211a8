# SPDX-License-Identifier: GPL-3.0-or-later
"""The color layer against closed forms: Lambert on a sphere, coverage at edges, textures, attributes, exposure."""

import json

import numpy as np
import pytest
from native_core import Mesh, box, core, scene, sphere, view

from addon import pipeline, style

SIZE = (160, 120)
SUN = (0.3, -0.5, 0.8)  # the way to it
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


def sun(strength=3.0, way=SUN):
    return core.Light("sun", (0, 0, 0), tuple(-np.array(way)), (strength,) * 3)


def plain(color, **slot):
    return core.SurfaceColor([core.ColorSlot(color, **slot)])


def passes(placed, seen, sources, shading="flat", bands=3, **options):
    """The passes of a picture without lines."""
    parts = {"line_sets": [{"kinds": {"edge_mark": {}}}], "color": {"shading": shading, "bands": bands}}
    chosen = style.parse(json.dumps({"schema": style.SCHEMA, **parts}))
    made = pipeline.frame(placed, seen, chosen, core.CpuBackend(), pipeline.options(**options), colors=sources)
    made.picture()
    return made.passes()


def layer(surfaces, colors, shading="flat", lights=(), world=(0, 0, 0), seen=None, bands=3, matrices=None, usage=None):
    seen = seen or view((4, -3, 2), (0, 0, 0), size=SIZE)
    sources = core.ColorSources(list(colors), list(lights), world)
    return passes(scene(surfaces, matrices, usage), seen, sources, shading, bands)["color"]


def sphere_normals(eye, orthographic, size=SIZE):
    """(H, W, 3) normals of the unit sphere at each pixel's center, nan beside it, for `view` towards the origin."""
    eye = np.array(eye, float)
    back = eye / np.linalg.norm(eye)
    right = np.cross((0, 0, 1), back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right)
    x, y = np.meshgrid((np.arange(size[0]) + 0.5) / size[0] * 2 - 1, (np.arange(size[1]) + 0.5) / size[1] * 2 - 1)
    ratio = size[1] / size[0]
    if orthographic:
        reach = np.linalg.norm(eye) / 2
        origin = eye + reach * (x[..., None] * right + ratio * y[..., None] * up)
        way = np.broadcast_to(-back, origin.shape)
    else:
        origin = np.broadcast_to(eye, (*x.shape, 3))
        way = x[..., None] / 2 * right + ratio * y[..., None] / 2 * up - back
        way = way / np.linalg.norm(way, axis=2, keepdims=True)
    b = (origin * way).sum(2)
    root = b**2 - (origin**2).sum(2) + 1
    t = -b - np.sqrt(np.where(root > 0, root, np.nan))
    return origin + t[..., None] * way


@pytest.mark.parametrize("orthographic", [False, True])
def test_a_sphere_in_the_sun_is_lambert(orthographic):
    eye = (4, -3, 2)
    seen = view(eye, (0, 0, 0), orthographic=orthographic, size=SIZE)
    found = layer([sphere(48).surface()], [plain((0.8, 0.4, 0.2))], "smooth", [sun()], seen=seen)
    normals = sphere_normals(eye, orthographic)
    facing = np.maximum(normals @ (np.array(SUN) / np.linalg.norm(SUN)), 0)
    ambient = 0.2  # the least there is, for a black sky
    expected = np.array([0.8, 0.4, 0.2]) * (ambient + (1 - ambient) * facing)[..., None]
    # A hair inside the outline, where the mesh is the sphere.
    inside = np.isfinite(facing) & (found[..., 3] == 1)
    inside[1:-1, 1:-1] &= inside[2:, 1:-1] & inside[:-2, 1:-1] & inside[1:-1, 2:] & inside[1:-1, :-2]
    assert inside.sum() > 1500
    assert np.abs(found[..., :3] - expected)[inside].max() < 0.02
    assert np.abs(found[..., :3] - expected)[inside].mean() < 0.003
    assert np.array_equal(found, layer([sphere(48).surface()], [plain((0.8, 0.4, 0.2))], "smooth", [sun()], seen=seen))


def test_without_lights_there_is_one_at_the_eye():
    eye = (0, -5, 0)
    found = layer([sphere(48).surface()], [plain((1, 1, 1))], "smooth", seen=view(eye, (0, 0, 0), size=SIZE))
    middle = found[SIZE[1] // 2, SIZE[0] // 2, 0]
    assert middle == pytest.approx(1, abs=0.01)
    assert found[..., 0][found[..., 3] == 1].min() < 0.6


@pytest.mark.parametrize("strength", [0.01, 3.0, 1e5])
def test_the_exposure_does_not_care_for_units(strength):
    lamp = core.Light("point", (3, -3, 4), (0, 0, -1), (strength,) * 3)
    found = layer([sphere(32).surface()], [plain((1, 1, 1))], "smooth", [lamp])
    assert 0.9 < found[..., 0].max() <= 1.0001


def test_size_does_not_matter_either():
    lamp = core.Light("point", (3, -3, 4), (0, 0, -1), (1, 1, 1))
    far = core.Light("point", (300, -300, 400), (0, 0, -1), (1, 1, 1))
    one = layer([sphere(32).surface()], [plain((1, 1, 1))], "smooth", [lamp])
    seen = view((400, -300, 200), (0, 0, 0), size=SIZE, far=1e5)
    matrices = [np.diag([100, 100, 100, 1])]
    large = layer([sphere(32).surface()], [plain((1, 1, 1))], "smooth", [far], seen=seen, matrices=matrices)
    assert np.abs(one - large).max() < 0.02


def test_a_spot_ends_at_its_cone():
    cone = np.cos(np.radians([12, 10]))
    lamp = core.Light("spot", (0, 0, 6), (0, 0, -1), (1, 1, 1), *cone)
    floor = box((-4, -4, -1), (4, 4, 0)).surface()
    found = layer([floor], [plain((1, 1, 1))], "smooth", [lamp], seen=view((0, 0, 12), (0, 0, 0), size=SIZE))
    lit, dark = found[SIZE[1] // 2, SIZE[0] // 2, 0], found[SIZE[1] // 2, SIZE[0] // 2 + 40, 0]
    assert lit == pytest.approx(1, abs=0.02) and dark == pytest.approx(0.2, abs=0.01)


def test_toon_has_as_many_tones_as_bands():
    found = layer([sphere(64).surface()], [plain((1, 1, 1))], "toon", [sun()], bands=4)
    tones = found[..., 0][found[..., 3] == 1]
    levels = 0.2 + 0.8 * np.arange(4) / 3
    nearest = np.abs(tones[:, None] - levels).min(1)
    assert (nearest < 0.01).mean() > 0.85
    assert [(np.abs(tones - level) < 0.01).sum() > 50 for level in levels] == [True] * 4


@pytest.mark.parametrize("turn", [3, 17, 45, 80])
def test_edges_cover_their_share(turn):
    """A half plane, whose coverage of a pixel is known: exact to .1, and without a bias."""
    angle = np.radians(turn)
    across, along = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    corners = [0.013 * across + side * 9 * along + reach * across for reach, side in ((0, 1), (0, -1), (9, -1), (9, 1))]
    quad = Mesh("quad", np.array([(*c, 0) for c in corners]), [(0, 1, 2, 3)])
    seen = view((0, 0, 4), (0, 0, 0), orthographic=True, size=SIZE)
    found = layer([quad.surface()], [plain((0.5, 0.5, 0.5))], seen=seen)
    step = 2 * 2 / SIZE[0]
    places = (np.arange(16) + 0.5) / 16 - 0.5
    x, y = np.meshgrid(np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2, np.arange(SIZE[1]) + 0.5 - SIZE[1] / 2)
    u, v = np.meshgrid(places, places)
    px = np.stack([x[..., None] + u.ravel(), y[..., None] + v.ravel()], -1) * step
    exact = (px @ across > 0.013).mean(-1)
    assert np.abs(found[..., 3] - exact).max() < 0.1
    assert abs((found[..., 3] - exact).mean()) < 2e-4
    assert np.allclose(found[..., :3], 0.5 * found[..., 3:], atol=1e-6)


def test_colors_meet_without_a_gap_and_do_not_bleed():
    ground, block = box((-60, -60, -2), (60, 60, -1)).surface(), box().surface()
    red, blue = (1, 0, 0), (0, 0, 1)
    found = layer([ground, block], [plain(red), plain(blue)], seen=view((4, -3, 5), (0, 0, 0), size=SIZE))
    assert (found[..., 3] == 1).all() and np.allclose(found[..., 0] + found[..., 2], 1, atol=1e-6)
    mixed = (found[..., 0] > 0) & (found[..., 2] > 0)
    # Only pixels that an edge crosses: none has all four neighbors mixed, too.
    inner = mixed[1:-1, 1:-1] & mixed[2:, 1:-1] & mixed[:-2, 1:-1] & mixed[1:-1, 2:] & mixed[1:-1, :-2]
    assert 0.005 < mixed.mean() < 0.04 and not inner.any()


def square(**color):
    """The unit square seen from above, filling half the picture's width, with uvs that are its x and y."""
    corners = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], float)
    surface = Mesh("square", corners, [(0, 1, 2, 3)]).surface()
    seen = view((0.5, 0.5, 2), (0.5, 0.5, 0), orthographic=True, size=SIZE)
    return layer([surface], [core.SurfaceColor(**color)], seen=seen)[20:100, 40:120]


def test_a_texture_lies_where_its_uvs_say():
    uvs = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], np.float32)
    ramp = np.tile(np.linspace(0, 1, 80, dtype=np.float32)[None, :, None], (80, 1, 3))
    ramp[..., 1] = np.linspace(0, 1, 80)[:, None]
    found = square(slots=[core.ColorSlot((1, 1, 1), core.ColorTexture(ramp, False), 0)], uvs=[uvs])
    assert np.abs(found[2:-2, 2:-2, :3] - ramp[2:-2, 2:-2]).max() < 0.03
    gray = core.ColorTexture(np.full((4, 4, 3), 0.5, np.float32), True)
    encoded = square(slots=[core.ColorSlot((1, 1, 1), gray, 0)], uvs=[uvs])
    assert np.allclose(encoded[..., :3], 0.2140, atol=0.002)


def test_a_fine_texture_seen_from_afar_is_its_mean():
    uvs = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], np.float32) * 40
    checks = (np.indices((16, 16)).sum(0) % 2).astype(np.float32)[..., None]
    found = square(slots=[core.ColorSlot((1, 1, 1), core.ColorTexture(checks, False), 0)], uvs=[uvs])
    assert np.abs(found[4:-4, 4:-4, :3] - 0.5).max() < 0.03


def test_an_attribute_is_mixed_over_the_face():
    colors = np.array([(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)], np.float32)
    found = square(slots=[core.ColorSlot((1, 1, 1), attribute=0)], attributes=[colors])
    for corner, at in zip(colors, ((2, 2), (2, -3), (-3, -3), (-3, 2)), strict=True):
        assert np.abs(found[at][:3] - corner).max() < 0.08


@pytest.mark.parametrize("channels", [1, 2, 3, 4])
def test_images_of_any_kind(channels):
    uvs = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], np.float32)

    def drawn(encoded):
        return square(slots=[core.ColorSlot((1, 1, 1), core.ColorTexture(pixels, encoded), 0)], uvs=[uvs])

    pixels = np.full((2, 2, channels), 0.25, np.float32)
    assert np.allclose(drawn(False)[..., :3], 0.25, atol=0.004)
    pixels[0, 0, 0] = np.nan
    assert (drawn(True)[..., :3] <= 0.06).all()


def test_holdouts_and_the_background_have_no_color():
    holdout = core.Usage.OCCLUDE | core.Usage.HOLDOUT
    assert (layer([sphere(16).surface()], [None], usage=[holdout]) == 0).all()


def test_what_does_not_fit_is_refused():
    surface = box().surface()
    with pytest.raises(ValueError, match="one entry per placement"):
        layer([surface], [])
    with pytest.raises(ValueError, match="box: one uv per corner"):
        layer([surface], [core.SurfaceColor([core.ColorSlot((1, 1, 1))], uvs=[np.zeros((3, 2), np.float32)])])
    with pytest.raises(ValueError, match="box: a slot must name an attribute that is given"):
        layer([surface], [plain((1, 1, 1), attribute=2)])
    with pytest.raises(ValueError, match="light: kind is 'laser'; it can be: sun, point, spot, area"):
        core.Light("laser", (0, 0, 0), (0, 0, 1), (1, 1, 1))


def test_a_picture_larger_than_a_tile_has_no_seam():
    size = (4200, 24)
    seen, placed = view((4, -3, 2), (0, 0, 0), size=size), scene([box((-9, -9, -2), (9, 9, 0)).surface()])
    found = passes(placed, seen, core.ColorSources([plain((1, 1, 1))], [], (0, 0, 0)), with_depth=True)
    found, hit = found["color"], found["depth"] < 1e9
    assert 0.2 < hit.mean() and np.mean((found[..., 3] > 0.5) == hit) > 0.995
    assert np.abs(np.diff(found[..., 3], axis=1))[:, 2040:2056].max() == 0
