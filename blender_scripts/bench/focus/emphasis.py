# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the emphasis by focus: the same disc of the picture, once in focus and once far from the focus."""

import numpy as np
from bl_ext.user_default.fovea import style

from . import reproject
from .world import named_style

STYLES = ("pen_and_ink", "watercolor")
COLORFUL = ("watercolor",)
NEAR, FAR = 0.1, 0.6  # heights of the image, as `fovea draw --focus` has them
FAR_IN_SCENE = 0.35  # outer radius over the distance to the camera; a focus elsewhere in the room leaves a place out
GRID = (6, 4)  # columns and rows of candidate focus points in the image
RINGS = 10  # bins of the focus value f between 0 and 1
LEAST_INK = 0.002  # bins with less mean ink in the picture all in focus are ignored


def display(picture):
    """(H, W, 3) sRGB-encoded from scene-linear colors."""
    linear = np.clip(picture[..., :3], 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def edge_contrast(picture):
    """(H, W) magnitude of the gradient of display luminance, per pixel."""
    rows, columns = np.gradient(display(picture) @ (0.2126, 0.7152, 0.0722))
    return np.hypot(rows, columns)


def saturation(picture):
    """(H, W) HSV saturation."""
    shown = display(picture)
    most = shown.max(axis=-1)
    return (most - shown.min(axis=-1)) / np.maximum(most, 1e-6)


def line_density(drawn, inside):
    """Total length in pixels of the lines inside a region, weighted by the opacity factor of elision; inside((n, 2)
    pixels) -> (n,) bool."""
    places = drawn.places()
    within = inside(places.px)
    return float((places.length_px * places.shown)[within].sum())


class Disc:
    """A disc with the inner radius around a point `at` of the image, 0..1 from the left and the top."""

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
    """A World and a Style, to be drawn with varying focus."""

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
        """The FocusPlace for a point in the image; in the model "scene" at the surface seen there."""
        if self.model == "image":
            return style.FocusPlace(at=(*at, 0.0), near=NEAR, far=FAR)
        place = self.world_points[self._pixel(at)]
        eye = np.linalg.inv(self.world.view.world_to_view)[:3, 3]
        distance = float(np.linalg.norm(place - eye))
        return style.FocusPlace(at=place.tolist(), near=NEAR * distance, far=FAR_IN_SCENE * distance)

    def at(self, place):
        """The Drawn with focus at a point in the image."""
        return self.world.draw(self.base.replace(focus=style.Focus(model=self.model, points=(self.point(place),))))

    def focus_of_pixels(self, drawn):
        """(H, W) focus of the lines at each pixel: that of the nearest surface around it, on whose silhouette they
        lie."""
        return drawn.frame.focus_function.of_pixels(drawn.frame.view, self.points.distance)

    def busiest(self, count):
        """The `count` candidate points with most ink around them when everything is in focus."""
        ink = self.sharp.image.lines[..., 3]
        return sorted(self.places, key=lambda at: -ink[Disc(at, self.world.view).mask].mean())[:count]

    def elsewhere(self, place):
        """The candidate point for which, as the focus, `place` is most out of focus."""

        def out(other):
            point = self.point(other)
            if self.model == "image":
                aspect = self.world.view.width / self.world.view.height
                return np.hypot((other[0] - place[0]) * aspect, other[1] - place[1]) / point.far
            return np.linalg.norm(np.subtract(point.at, self.point(place).at)) / point.far

        return max(self.places, key=out)


def fall_off(f, ink, sharp):
    """(RINGS + 2,) share of ink kept in each bin of f: f <= 0, RINGS equal bins, f >= 1. NaN: the bin had too
    little."""
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
    """({measure: ratio in focus / out of focus}, largest jump): minimum and maximum over so many focus points."""
    ratios, jumps = {}, []
    for place in stage.busiest(places):
        disc, here, away = Disc(place, stage.world.view), stage.at(place), stage.at(stage.elsewhere(place))
        mine, theirs = disc.measures(here, colorful), disc.measures(away, colorful)
        for what, value in mine.items():
            ratios.setdefault(what, []).append(float(value / max(theirs[what], 1e-9)))
        ink, sharp = here.image.lines[..., 3], stage.sharp.image.lines[..., 3]
        jumps.append(largest_jump(fall_off(stage.focus_of_pixels(here), ink, sharp)))
    return {what: min(values) for what, values in ratios.items()}, max(jumps)
