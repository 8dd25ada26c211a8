# SPDX-License-Identifier: GPL-3.0-or-later
"""What focus does to the place it is at: the same disc of the picture, once in focus and once far from it."""

import numpy as np
from bl_ext.user_default.fovea import style

from . import reproject
from .world import named_style

STYLES = ("pen_and_ink", "watercolor")
COLORFUL = ("watercolor",)
NEAR, FAR = 0.1, 0.6  # heights of the image, as `fovea draw --focus` has them
FAR_IN_SCENE = 0.35  # distances of the camera: where one looks elsewhere in a room, the place itself is out of focus
GRID = (6, 4)  # of places that can be looked at
RINGS = 10  # of f between in focus and out of it
LEAST_INK = 0.002  # a ring with less of it, all in focus, tells nothing


def display(picture):
    """(H, W, 3) as a screen shows scene-linear colors."""
    linear = np.clip(picture[..., :3], 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def edge_contrast(picture):
    """(H, W) how much the luminance changes from pixel to pixel."""
    rows, columns = np.gradient(display(picture) @ (0.2126, 0.7152, 0.0722))
    return np.hypot(rows, columns)


def saturation(picture):
    """(H, W) as HSV has it."""
    shown = display(picture)
    most = shown.max(axis=-1)
    return (most - shown.min(axis=-1)) / np.maximum(most, 1e-6)


def line_density(drawn, inside):
    """Pixels of line, by their opacity under elision, per pixel of a disc; inside((n, 2) pixels) -> (n,) bool."""
    places = drawn.places()
    within = inside(places.px)
    return float((places.length_px * places.shown)[within].sum())


class Disc:
    """Around a place in the image, 0..1 from the left and the top, within the near radius."""

    def __init__(self, at, view):
        self.middle, self.radius = np.array((at[0] * view.width, (1 - at[1]) * view.height)), NEAR * view.height
        rows, columns = np.mgrid[: view.height, : view.width] + 0.5
        self.mask = np.hypot(columns - self.middle[0], rows - self.middle[1]) < self.radius

    def holds(self, px):
        return np.hypot(*(px - self.middle).T) < self.radius

    def measures(self, drawn, colorful):
        told = {
            "edge contrast": edge_contrast(drawn.image.combined)[self.mask].mean(),
            "line density": line_density(drawn, self.holds) / self.mask.sum(),
            "ink": drawn.image.lines[..., 3][self.mask].mean(),
        }
        return told | ({"saturation": saturation(drawn.image.combined)[self.mask].mean()} if colorful else {})


class Stage:
    """A World and a Style of which only the focus changes."""

    def __init__(self, world, name, model):
        self.world, self.base, self.model = world, named_style(name), model
        self.sharp = world.draw(self.base.replace(focus=style.Focus()))
        self.points = reproject.Seen(world.view, self.sharp.image.depth)
        self.world_points = self.points.points()
        columns, rows = ((np.arange(n) + 0.5) / n for n in GRID)
        grid = [(float(u), float(v)) for v in rows for u in columns]
        self.places = [at for at in grid if model == "image" or self._distance(at) < reproject.NOTHING]

    def _pixel(self, at):
        return int((1 - at[1]) * self.world.view.height), int(at[0] * self.world.view.width)

    def _distance(self, at):
        return self.points.distance[self._pixel(at)]

    def point(self, at):
        """The FocusPlace that looks at a place in the image."""
        if self.model == "image":
            return style.FocusPlace(at=(*at, 0.0), near=NEAR, far=FAR)
        place = self.world_points[self._pixel(at)]
        eye = np.linalg.inv(self.world.view.world_to_view)[:3, 3]
        distance = float(np.linalg.norm(place - eye))
        return style.FocusPlace(at=place.tolist(), near=NEAR * distance, far=FAR_IN_SCENE * distance)

    def at(self, place):
        """Drawn, looking there."""
        return self.world.draw(self.base.replace(focus=style.Focus(model=self.model, points=(self.point(place),))))

    def focus_of_pixels(self, drawn):
        """(H, W) f of the lines there: of the nearest surface around, as lines lie on its border."""
        return drawn.frame.focus_function.of_pixels(drawn.frame.view, self.points.distance)

    def busiest(self, count):
        """The places with most lines, all in focus."""
        ink = self.sharp.image.lines[..., 3]
        return sorted(self.places, key=lambda at: -ink[Disc(at, self.world.view).mask].mean())[:count]

    def elsewhere(self, place):
        """The place from which that one is out of focus the most."""

        def out(other):
            point = self.point(other)
            if self.model == "image":
                aspect = self.world.view.width / self.world.view.height
                return np.hypot((other[0] - place[0]) * aspect, other[1] - place[1]) / point.far
            return np.linalg.norm(np.subtract(point.at, self.point(place).at)) / point.far

        return max(self.places, key=out)


def fall_off(f, ink, sharp):
    """(RINGS + 2,) share of its ink that each ring of f keeps: 0, RINGS equal steps, 1. nan: it never had any."""
    ring = np.where(f <= 0, 0, np.where(f >= 1, RINGS + 1, 1 + np.minimum((f * RINGS).astype(np.int64), RINGS - 1)))
    count = np.maximum(np.bincount(ring.ravel(), minlength=RINGS + 2), 1)
    left, whole = (np.bincount(ring.ravel(), values.ravel(), RINGS + 2) / count for values in (ink, sharp))
    return np.where(whole > LEAST_INK, left / np.maximum(whole, 1e-9), np.nan)


def largest_jump(shares):
    known = shares[np.isfinite(shares)]
    return float(np.abs(np.diff(known)).max()) if len(known) > 1 else 0.0


def rows(scene, world, places):
    found = []
    for name in STYLES:
        for model, words in (("image", "2D"), ("scene", "3D")):
            ratios, jump = compare(Stage(world, name, model), places, name in COLORFUL)
            wanted = {what: None if what == "ink" else ">= 2" for what in ratios}
            told = [(f"{what}, in focus / out of it", ratio, wanted[what]) for what, ratio in ratios.items()]
            told += [("ink, largest jump between rings", jump, "<= .2")]
            found += [
                {"figure": f"{name}, {words}: {figure}", "scene": scene, "value": value, "wanted": wanted}
                for figure, value, wanted in told
            ]
    return found


def compare(stage, places, colorful):
    """({measure: ratio}, largest jump): the least ratio, and the largest jump, of so many places."""
    ratios, jumps = {}, []
    for place in stage.busiest(places):
        disc, here, away = Disc(place, stage.world.view), stage.at(place), stage.at(stage.elsewhere(place))
        mine, theirs = disc.measures(here, colorful), disc.measures(away, colorful)
        for what, value in mine.items():
            ratios.setdefault(what, []).append(float(value / max(theirs[what], 1e-9)))
        ink, sharp = here.image.lines[..., 3], stage.sharp.image.lines[..., 3]
        jumps.append(largest_jump(fall_off(stage.focus_of_pixels(here), ink, sharp)))
    return {what: min(values) for what, values in ratios.items()}, max(jumps)
