# SPDX-License-Identifier: GPL-3.0-or-later
"""Pens as wide and as dark as the strokes of drawings, where these are pictures that show it. Without Blender."""

from dataclasses import dataclass

import numpy as np

from .stages import REFERENCE_HEIGHT

LEAST_WIDTH = 1.3  # pixels: how narrow strokes can be to have a width and a darkness that can be told apart
LEAST_PIXELS = 50  # of strokes that are near to a line set
LIGHT = 0.2126, 0.7152, 0.0722  # of linear red, green, blue


@dataclass(frozen=True)
class Looked:
    """What strokes near the lines of a line set look like: medians. `width`: of the frame's pixels; `darkness`: share
    of the paper's light that they take away, None where it cannot be told."""

    name: str
    width: float
    darkness: float | None


def looked(names, drawn, laid, tolerance):
    """A Looked of each line set, or None where drawings do not show it. `drawn`: native Bitmaps of what the line sets
    of the `names` draw; `laid`: a registered_drawing.Laid of each drawing; `tolerance` [px]."""
    far = [bitmap.distances().ravel() for bitmap in drawn]
    of_sets = [[] for _ in names]
    for pixel, looks in (each.stroke_looks for each in laid if each.gray):
        near = np.array([distance[pixel] <= tolerance for distance in far])
        alone = near & (near.sum(axis=0) == 1)  # where strokes of two sets meet, neither can be measured
        for found, of_set in zip(of_sets, alone):
            found.append(looks[of_set])
    return [_medians(name, np.concatenate(found)) if found else None for name, found in zip(names, of_sets)]


def _medians(name, looks):
    widths, measured, darkness = looks.T
    if len(looks) < LEAST_PIXELS or np.median(measured) < LEAST_WIDTH:
        return None
    told = darkness[np.isfinite(darkness)]
    return Looked(name, float(np.median(widths)), float(np.median(told)) if len(told) >= LEAST_PIXELS else None)


def with_looks(made, looks, height):
    """A Style whose line sets have pens as wide and dark as a Looked of each, or None, in a frame of `height` px."""
    pens = [
        line_set.replace(pen=_pen(line_set.pen, look, made.paper, height)) if look else line_set
        for line_set, look in zip(made.line_sets, looks)
    ]
    return made.replace(line_sets=tuple(pens))


def _pen(pen, look, paper, height):
    units = {"pixels": 1.0, "reference": REFERENCE_HEIGHT / height, "millimetres": paper.height_mm / height}
    pen = pen.replace(width=float(f"{look.width * units[pen.width_unit]:.4g}"))
    light = np.dot(pen.color, LIGHT) / max(np.dot(paper.color, LIGHT), 1e-6)
    if look.darkness is None or light >= 1:
        return pen
    opacity = look.darkness / (1 - light)
    if opacity > 1:  # darker than the color is
        factor = (1 - look.darkness) / light
        pen = pen.replace(color=tuple(float(f"{factor * value:.4g}") for value in pen.color))
    return pen.replace(opacity=float(f"{min(opacity, 1.0):.4g}"))
