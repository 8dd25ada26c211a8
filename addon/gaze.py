# SPDX-License-Identifier: GPL-3.0-or-later
"""Where eyes go in a picture, by its salience (native/fovea/study/salience.h), and whether they go to the focus (Cole
2009, 5.3.3 and 5.4). Without Blender.

Pictures are (H, W, 3) uint8 as displayed, focus is (H, W) in [0, 1], 0 in focus; both bottom row first."""

from dataclasses import dataclass

import numpy as np

from . import files, heat_map, native

MOST = 5  # places that eyes go to, of which is told
SHARP = 1 / 31  # radius of what eyes see sharply: 1 degree of the 31 of the diagonal of the thesis's screen
WANTED_GAIN = 1.3  # of the salience in focus, by its effects
HALVINGS = 5  # of the search for an emphasis
VEIL = 0.7  # opacity of heat maps where they are warmest
RINGS = 3, 1.5  # pixels: width of those around the first place, and around the others


@dataclass(frozen=True)
class Gaze:
    """Where eyes go in a picture."""

    picture: np.ndarray
    salience: object  # native Salience
    places: np.ndarray  # (n, 2) pixels from the lower left, in the order in which eyes go there
    saliences: np.ndarray  # (n,) as shares of the first one's
    agreed: bool  # a second model has the same first place, within a sixth of the shorter side

    @property
    def radius(self):
        """Pixels that eyes see sharply around a place."""
        return SHARP * np.hypot(*self.picture.shape[:2])

    def sharp(self, number):
        """(H, W) bool: what eyes see sharply at a place."""
        return self.away(number) <= self.radius

    def away(self, number):
        """(H, W) distances of the pixels from a place."""
        rows, columns = np.ogrid[: self.picture.shape[0], : self.picture.shape[1]]
        x, y = self.places[number]
        return np.hypot(columns + 0.5 - x, rows + 0.5 - y)


@dataclass(frozen=True)
class Judged:
    """Whether eyes go to the focus of a picture, beside the same picture with focus the same all over."""

    share: float  # of all salience, in focus: emphasis under a gaze that is spread like salience
    share_evenly: float  # the same of the other picture
    ratio: float  # mean salience in focus over that out of it
    first_in_focus: bool  # something that eyes see sharply there first is not wholly out of focus

    @property
    def gain(self):
        """By how much focus draws the gaze: above 1 it does."""
        return self.share / max(self.share_evenly, 1e-9)

    @property
    def wins(self):
        return self.first_in_focus and self.gain >= WANTED_GAIN


def frame_size(width, height):
    """(width, height) of a frame as large as the models of salience look at it, but not larger than it is."""
    scale = min(1.0, native.load().Salience.usual_diagonal / np.hypot(width, height))
    return tuple(max(4, round(float(side) * scale)) for side in (width, height))


def look(picture):
    """The Gaze of a picture."""
    models, height, width = native.load().Salience, *picture.shape[:2]
    salience = models.itti_koch(picture)
    first, second = salience.fixations(MOST), models.spectral_residual(picture).fixations(1)
    places, others = (found[:, :2] * (width, height) for found in (first, second))
    near = min(width, height) / 6
    agreed = len(places) > 0 and len(others) > 0 and float(np.hypot(*(places[0] - others[0]))) < near
    return Gaze(picture, salience, places, first[:, 2], agreed)


def judge(gaze, evenly, focus):
    """The Judged of a picture's Gaze. `evenly`: that of the same picture with focus the same all over."""
    emphasis = 1 - np.asarray(focus, np.float32)
    share, area = gaze.salience.share(emphasis), float(emphasis.mean())
    inside, outside = share / max(area, 1e-9), (1 - share) / max(1 - area, 1e-9)
    first = bool(len(gaze.places)) and bool(emphasis[gaze.sharp(0)].any())
    return Judged(share, evenly.salience.share(emphasis), inside / max(outside, 1e-9), first)


def strengthened(drawn, now, most):
    """(emphasis, result) of the least emphasis between `now` and `most` at which the focus wins, of those tried, or of
    the most, if it does not win at that. `drawn(emphasis)`: a result with `judged`, a Judged. More is taken to be never
    worse."""
    low, high, best = now, most, drawn(most)
    for _ in range(HALVINGS):
        middle = round(float(np.sqrt(low * high)), 2)
        if not (best.judged.wins and low < middle < high):
            break
        found = drawn(middle)
        if found.judged.wins:
            high, best = middle, found
        else:
            low = middle
    return high, best


def told(gaze, names=(), judged=None):
    """A dict of numbers and words of a Gaze. `names`: of the objects at its places, "" where there is none."""
    height, width = gaze.picture.shape[:2]
    places = [
        {"x": round(float(x / width), 4), "y": round(float(1 - y / height), 4), "salience": round(float(value), 4)}
        for (x, y), value in zip(gaze.places, gaze.saliences)
    ]
    for place, name in zip(places, names):
        place["object"] = name or None
    found = {"fixations": places, "second_opinion_agrees": gaze.agreed}
    if judged:
        found["focus"] = {
            "wins": judged.wins, "first": judged.first_in_focus, "gain": judged.gain, "share": judged.share,
            "share_evenly": judged.share_evenly, "inside_over_outside": judged.ratio,
        }  # fmt: skip
    return found


def sentence(gaze, names=(), judged=None):
    """The same in words."""
    if not len(gaze.places):
        return "Nothing in this picture stands out"
    x, y = gaze.places[0] / gaze.picture.shape[1::-1]
    name = names[0] if len(names) else ""
    words = f"The eye goes to '{name}' first" if name else f"The eye goes first to {x:.2f},{1 - y:.2f} of the frame"
    if judged:
        words += f", {'in' if judged.first_in_focus else 'out of'} focus; focus draws {judged.gain:.2f} times the gaze"
        words += f" of the same picture without it: it {'wins' if judged.wins else 'does not win'}"
    return words if gaze.agreed else f"{words} (a second model would look elsewhere first)"


def write(gaze, path):
    """Writes the heat map as a PNG file, which is whole or not there."""
    with files.written(path) as fresh:
        fresh.write_bytes(native.load().png_bytes(heat(gaze)))


def heat(gaze):
    """(H, W, 3) uint8 as displayed: a Gaze's picture in gray, under warm colors where it is salient, with rings around
    the places that eyes go to."""
    height, width = gaze.picture.shape[:2]
    salience = gaze.salience.of_pixels(width, height)[..., None]
    gray = (gaze.picture.mean(axis=2, keepdims=True) / 255).astype(np.float32)
    veil = VEIL * np.sqrt(salience)
    shown = gray * (1 - veil) + heat_map.colors(1 - salience[..., 0]) * veil
    for number in range(len(gaze.places)):
        shown[np.abs(gaze.away(number) - gaze.radius) < RINGS[min(number, 1)] / 2] = 0
    return np.rint(255 * shown).astype(np.uint8)
