# SPDX-License-Identifier: GPL-3.0-or-later
"""The colour effects against plain NumPy, and what focus asks of them: nothing bleeds, nothing is lost."""

import numpy as np
import pytest
from native_core import core

LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


def desaturate(image, amount):
    return core.color_effects(image, desaturate=amount)


def fade(image, amount, background=None):
    return core.color_effects(image, fade=amount, background=background)


def blur(image, radius):
    return core.color_effects(image, blur_px=radius)


@pytest.fixture
def image():
    random = np.random.default_rng(3)
    alpha = random.random((23, 37, 1))
    return np.concatenate([random.random((23, 37, 3)) * alpha, alpha], 2).astype(np.float32)


@pytest.fixture
def amount():
    return np.clip(np.random.default_rng(4).random((23, 37)) * 1.4 - 0.2, 0, 1).astype(np.float32)


def diffused(image, radius, rounds=2):
    """Solves for each row and column by a general solver."""
    result = image.astype(float)
    strength = radius.astype(float) ** 2 / (8 * rounds)
    for axis in [1, 0] * rounds:
        lines, weights = np.moveaxis(result, axis, 1), np.moveaxis(strength, axis, 1)
        for line, weight in zip(lines, weights):
            flow = np.minimum(weight[:-1], weight[1:])
            matrix = np.eye(len(line)) - np.diag(flow, 1) - np.diag(flow, -1)
            matrix += np.diag(np.append(flow, 0) + np.append(0, flow))
            line[:] = np.linalg.solve(matrix, line)
    return result


def test_desaturate(image, amount):
    grey = (image[..., :3] @ LUMINANCE)[..., None]
    expected = image[..., :3] + (grey - image[..., :3]) * amount[..., None]
    result = desaturate(image, amount)
    assert np.allclose(result[..., :3], expected, atol=1e-6)
    assert np.array_equal(result[..., 3], image[..., 3])
    assert np.allclose(result[..., :3] @ LUMINANCE, image[..., :3] @ LUMINANCE, atol=1e-6)


def test_fade(image, amount):
    share = amount[..., None]
    assert np.allclose(fade(image, amount), image * (1 - share), atol=1e-6)
    color = np.array([0.9, 0.5, 0.1])
    result = fade(image, amount, color)
    assert np.allclose(result[..., :3], image[..., :3] * (1 - share) + color * image[..., 3:] * share, atol=1e-6)
    assert np.array_equal(result[..., 3], image[..., 3])


@pytest.mark.parametrize("radius", [1.5, 6.0, 40.0])
def test_blur_is_diffusion(image, amount, radius):
    assert np.allclose(blur(image, amount * radius), diffused(image, amount * radius), atol=2e-5)


def test_the_order_of_effects(image, amount):
    together = core.color_effects(image, amount, 0.5 * amount, (1, 0.5, 0), 6 * amount)
    assert np.array_equal(together, blur(fade(desaturate(image, amount), 0.5 * amount, (1, 0.5, 0)), 6 * amount))
    assert core.color_effects(image).tobytes() == image.tobytes()


def test_nothing_is_changed_where_the_amount_is_nothing(image, amount):
    none = np.zeros_like(amount)
    faded = fade(image, none), fade(image, none, (1, 0, 0))
    for result in (desaturate(image, none), *faded, blur(image, none)):
        assert result.tobytes() == image.tobytes()
    some = np.where(amount > 0.5, amount, 0).astype(np.float32)
    for result in (desaturate(image, some), fade(image, some), blur(image, 9 * some)):
        assert np.array_equal(result[some == 0], image[some == 0])
        assert not np.array_equal(result[some > 0], image[some > 0])


def test_blur_keeps_the_sum_and_what_is_even(image, amount):
    blurred = blur(image, 12 * amount)
    assert np.allclose(blurred.sum((0, 1)), image.sum((0, 1)), rtol=1e-5)
    assert blurred.min() >= 0 and blurred.max() <= image.max() + 1e-6
    even = np.full_like(image, 0.4)
    assert np.allclose(blur(even, 30 * amount), even, atol=1e-5)


def test_what_is_in_focus_bleeds_nowhere():
    image = np.zeros((64, 64, 4), np.float32)
    image[..., 3] = 1
    image[..., 2] = 0.2
    image[20:40, 20:40] = (1, 0, 0, 1)
    radius = np.full((64, 64), 10, np.float32)
    radius[20:40, 20:40] = 0
    blurred = blur(image, radius)
    assert np.array_equal(blurred[20:40, 20:40], image[20:40, 20:40])
    ground = radius > 0
    assert blurred[ground][:, 0].max() == 0
    assert np.allclose(blurred[ground][:, 2], 0.2, atol=1e-6)


def test_a_point_spreads_as_wide_as_its_disc_and_evenly():
    image = np.zeros((129, 129, 4), np.float32)
    image[64, 64] = 1
    for radius in (4.0, 12.0):
        spread = blur(image, np.full((129, 129), radius, np.float32))[..., 0].astype(float)
        y, x = np.mgrid[-64:65, -64:65]
        assert spread.sum() == pytest.approx(1, abs=1e-4)
        for square in (x * x, y * y):  # the variance of a disc along an axis
            assert (spread * square).sum() == pytest.approx(radius**2 / 4, rel=0.02)
        assert np.allclose(spread, spread.T, atol=1e-6) and np.allclose(spread, spread[::-1, ::-1], atol=1e-6)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_what_is_no_number_stays_alone(image, amount, bad):
    radius = np.full_like(amount, 8)
    clean = blur(image, radius)
    image[11, 17] = bad
    blurred = blur(image, radius)
    assert np.isfinite(np.delete(blurred.reshape(-1, 4), 11 * 37 + 17, axis=0)).all()
    assert np.abs(blurred[0, 0] - clean[0, 0]).max() < 0.05
    amount[3, 4] = np.nan
    for result in (desaturate(image, amount), fade(image, amount), blur(image, amount)):
        assert np.array_equal(result[3, 4], image[3, 4])


def test_sizes_that_do_not_fit_are_refused(image, amount):
    for effect in (desaturate, fade, blur):
        with pytest.raises(ValueError, match="expected one"):
            effect(image, amount[:-1])
        with pytest.raises(ValueError, match="image: expected shape"):
            effect(image[..., :3], amount)
