# SPDX-License-Identifier: GPL-3.0-or-later
"""How a hand draws, found in drawings whose strokes wobble and overshoot by known amounts, without Blender."""

import numpy as np
import pytest
from native_core import core

from addon import fitted_hand, registered_drawing, style

SIZE, FINE = (640, 480), 6  # pixels, and parts of a pixel each way
WIDTH = 2.0  # of strokes, pixels
LINE_SET = style.load("plain").line_sets[1]
ROWS = np.arange(30, 460, 26)


def noise(random, x):
    """Values at integers, smoothly between them; at x (n,)."""
    values, below = random.uniform(-1, 1, int(x.max()) + 3), np.floor(x).astype(int)
    t = x - below
    share = t**3 * (t * (6 * t - 15) + 10)
    return (1 - share) * values[below] + share * values[below + 1]


def way(random, s, length, wave):
    """(n,) how far a pen is from a line at arc lengths s (n,), of at most 1: two octaves, none at both ends, and
    straight between points, six of a wave."""
    at = np.append(np.arange(0, length, wave / 6), length)
    far = (2 * noise(random, at / wave) + noise(random, 2 * at / wave)) / 3
    return np.interp(s, at, far * np.clip(np.minimum(at, length - at) / wave, 0, 1))


def picture(strokes):
    """The Laid of a picture of strokes, (n, 2) pixels each."""
    px = np.concatenate(strokes).astype(np.float32)
    offsets = np.concatenate([[0], np.cumsum([len(stroke) for stroke in strokes])]).astype(np.int64)
    fine = core.Bitmap.of_lines(px * FINE, offsets, SIZE[0] * FINE, SIZE[1] * FINE)
    ink = (fine.distances() <= WIDTH * FINE / 2).reshape(SIZE[1], FINE, SIZE[0], FINE).mean(axis=(1, 3))
    gray = core.GrayImage(np.rint(255 * (1 - ink)).astype(np.uint8))
    return registered_drawing.Laid(gray.lines(), gray)


def drawn(random, rows, x0=40.0, x1=600.0, *, over=0.0, amount=0.0, wave=60.0, shift=lambda x: 0 * x):
    """Strokes along level lines from x0 to x1 at the rows."""
    x = np.arange(x0 - over, x1 + over + 0.5, 0.5)
    s, length = x - x[0], x1 - x0 + 2 * over
    return [np.stack([x, row + shift(x) + amount * way(random, s, length, wave)], axis=1) for row in rows]


def lines(rows, x0=40.0, x1=600.0):
    """What fitted_hand.ended gives of such lines, all of whose ends are free."""
    px = np.array([[(x0, row), (x1, row)] for row in rows], np.float32).reshape(-1, 2)
    offsets, count = np.arange(0, len(px) + 1, 2), len(rows)
    lengths = np.full(count, x1 - x0)
    return {"px": px, "offsets": offsets, "is_free": np.ones(2 * count, np.uint8), "length": lengths}


def every(*of):
    pixels = sum(core.Bitmap.of_lines(each["px"], each["offsets"], *SIZE).pixels for each in of)
    return core.Bitmap(np.minimum(pixels, 1).astype(np.uint8))


def hand(strokes, of, *others, line_set=LINE_SET):
    (found,) = fitted_hand.hands([line_set], [of], [picture(strokes)], every(of, *others))
    return found


@pytest.mark.parametrize("amount, wave", [(3.0, 60.0), (2.0, 110.0), (1.5, 30.0), (1.0, 45.0)])
def test_the_wobble_of_a_drawing_is_found_again(amount, wave):
    random = np.random.default_rng(int(wave))
    found = hand(drawn(random, ROWS, amount=amount, wave=wave), lines(ROWS))
    assert found.wobble == pytest.approx(amount, rel=0.15) and found.wobble_length == pytest.approx(wave, rel=0.15)
    assert found.overshoot == 0


@pytest.mark.parametrize("over", [4.0, 9.0, 25.0])
def test_the_overshoot_of_a_drawing_is_found_again(over):
    random = np.random.default_rng(1)
    found = hand(drawn(random, ROWS, over=over), lines(ROWS))
    assert found.overshoot == pytest.approx(over, rel=0.1) and found.wobble == 0 and found.wobble_length is None


def test_both_are_found_together():
    random = np.random.default_rng(2)
    found = hand(drawn(random, ROWS, over=10.0, amount=2.5, wave=70.0), lines(ROWS))
    assert found.overshoot == pytest.approx(10, rel=0.15)
    assert found.wobble == pytest.approx(2.5, rel=0.15) and found.wobble_length == pytest.approx(70, rel=0.15)


def test_a_drawing_that_is_moved_and_turned_a_little_does_not_wobble():
    random = np.random.default_rng(3)
    found = hand(drawn(random, ROWS, shift=lambda x: 0.8 + 0.003 * (x - 320)), lines(ROWS))
    assert (found.overshoot, found.wobble, found.wobble_length) == (0, 0, None)


def test_strokes_that_stop_before_the_ends_of_lines_do_not_overshoot():
    random = np.random.default_rng(4)
    assert hand(drawn(random, ROWS, over=-6.0), lines(ROWS)).overshoot == 0


def test_short_lines_which_overshoot_less_do_not_make_it_smaller():
    """As strokes go on by a quarter of their lines at most."""
    random, half = np.random.default_rng(5), 26.0
    short = np.arange(43, 460, 26)
    strokes = drawn(random, ROWS, 200.0, 600.0, over=16.0) + drawn(random, short, 60.0, 60.0 + half, over=half / 4)
    of, less = lines(ROWS, 200.0, 600.0), lines(short, 60.0, 60.0 + half)
    joined = {key: np.concatenate([of[key], less[key]]) for key in ("px", "is_free", "length")}
    joined["offsets"] = np.arange(0, len(joined["px"]) + 1, 2)
    assert hand(strokes, joined).overshoot == pytest.approx(16, rel=0.1)


def test_where_another_line_goes_on_or_is_near_nothing_is_told():
    random = np.random.default_rng(6)
    on = lines(ROWS, 604.0, 630.0)
    strokes = drawn(random, ROWS, 40.0, 600.0) + drawn(random, ROWS, 600.0, 630.0)
    before = lines(ROWS)
    before["is_free"][::2] = 0
    found = hand(strokes, before, on)
    assert found.overshoot is None and found.wobble == 0
    beside = lines(ROWS + 5)
    assert hand(drawn(random, ROWS), lines(ROWS), beside) is None, "which of both is drawn?"


def test_a_hand_becomes_a_style_in_pixels_of_an_image_1080_pixels_high():
    base = style.load("plain")
    found = [fitted_hand.Hand("forms", 4.0, 1.5, 30.0), fitted_hand.Hand("lines", None, 0.0, None)]
    forms, both = fitted_hand.with_hands(base, found, 480).line_sets
    assert (forms.overshoot, forms.pen.wobble, forms.pen.wobble_length) == (9.0, 3.375, 67.5)
    assert both == base.line_sets[1].replace(pen=base.line_sets[1].pen.replace(wobble=0.0))
    assert fitted_hand.with_hands(base, [None, None], 480) == base


def test_ends_that_are_told_are_those_of_whole_paths_inside_the_frame():
    """A path that is hidden in its middle, one that leaves the frame, a closed one, and one that fades at its end."""
    runs = [  # path, arc, x of both ends, invisibility, strength of its end, closed
        (0, (-50, -10), (100, 140), 0, 1.0, 0),
        (0, (-10, 10), (140, 160), 1, 1.0, 0),
        (0, (10, 50), (160, 200), 0, 1.0, 0),
        (1, (-30, 30), (1, 61), 0, 1.0, 0),
        (2, (-20, 20), (300, 340), 0, 1.0, 1),
        (3, (-20, 20), (400, 440), 0, 0.1, 0),
    ]
    path, arc, x, hidden, strength, closed = (np.array(values) for values in zip(*runs))
    found = {
        "px": np.stack([x.ravel(), np.full(2 * len(runs), 90)], axis=1).astype(np.float32),
        "offsets": np.arange(0, 2 * len(runs) + 1, 2), "path": path.astype(np.uint32), "arc_px": arc.ravel(),
        "invisibility": hidden, "strength": np.stack([np.ones(len(runs)), strength], axis=1).ravel(),
        "closed": closed.astype(bool), "shown": np.ones(len(runs)),
    }  # fmt: skip
    told = fitted_hand.ended(found, SIZE)
    assert told["is_free"].reshape(-1, 2).tolist() == [[1, 0], [0, 1], [0, 1], [0, 0], [1, 0]]
    assert told["length"].tolist() == [100, 100, 60, 40, 40] and len(told["px"]) == 10
    nothing = {key: value[:0] for key, value in found.items()} | {"offsets": np.zeros(1, np.int64)}
    assert fitted_hand.ended(nothing, SIZE)["offsets"].tolist() == [0]
