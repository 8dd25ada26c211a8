# SPDX-License-Identifier: GPL-3.0-or-later
"""Models of where artists draw lines, learned from drawings of a scene by the local properties of its pixels (Cole
2009, 3.2.4 and 3.2.5). Without Blender.

Pictures are bottom row first. How likely a line is at a pixel, which models learn, is the mean over drawings of a
Gaussian of the distance to the nearest line, 1 on a line, half a tolerance wide."""

import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from . import native

SEED = 1
BLOCK = 0.025  # side of the blocks by which pixels are held out, as a share of the diagonal
HELD_OUT = 4  # of so many blocks one is held out
NEAR = 0.1  # from which likelihood on a pixel is near to a line: all of these are learned from
OTHERS = 4  # times as many of the rest
MOST = 200_000  # pixels that are learned from
MOST_JUDGED = 50_000  # pixels that importance is judged by
LIKELY = 0.5  # from which likelihood on a pixel is one of lines, where models are judged by telling them from others
THRESHOLDS = np.linspace(0.02, 0.98, 49)  # of lines, that are tried


@dataclass(frozen=True)
class Learned:
    """A native LineModel, with the threshold of lines that are most like the drawings, and a dict of figures: see
    addon/docs/learn.md."""

    model: object
    found: dict


def kinds():
    """(name, label, description) of the kinds of models."""
    return native.load().LineModel.kinds


def likelihood(drawings, tolerance):
    """(H, W) float32 of Bitmaps of one size."""
    parts = [np.exp(-0.5 * (drawing.distances() / max(0.5 * tolerance, 0.5)) ** 2) for drawing in drawings]
    return np.mean(parts, axis=0, dtype=np.float32)


def held_out(height, width):
    """(H, W) bool: pixels that are not learned from, in blocks, as neighbors know of each other."""
    side = max(4, round(BLOCK * float(np.hypot(height, width))))
    rows, columns = np.ogrid[:height, :width]
    return (rows // side + 2 * (columns // side)) % HELD_OUT == 0


def read(path):
    """The native LineModel of a file. ValueError in a sentence if it is none."""
    text = native.load().style.file_bytes(os.fsencode(path)).decode("utf-8", errors="replace")
    try:
        return native.load().LineModel.of_json(text)
    except ValueError as error:
        raise ValueError(f"{Path(path).name}: {error}") from error


def learn(properties, drawings, kind="tree", tolerance=None, outlines=None):
    """The Learned of native LocalProperties and Bitmaps of the same view. `kind`: one of the native LineModel's.
    `outlines`: a Bitmap of those of the scene, which everyone draws; importance is that away from them. ValueError in a
    sentence if there is nothing to learn."""
    known = properties.known > 0
    for drawing in drawings:
        if drawing.pixels.shape != known.shape:
            (height, width), (rows, columns) = drawing.pixels.shape, known.shape
            raise ValueError(
                f"a drawing has {width} x {height} pixels, and the frame {columns} x {rows}: all have to be as large "
                "as each other, or scans that are registered by --register"
            )
    tolerance = drawings[0].usual_tolerance if tolerance is None else tolerance
    wanted = likelihood(drawings, tolerance)
    inside = known if outlines is None else known & (outlines.distances() > tolerance)
    held = held_out(*known.shape)
    random = np.random.default_rng(SEED)
    model = native.load().LineModel(kind, *_samples(properties, wanted, known & ~held, random))
    judged = _judged(model, properties, wanted, known & held)
    judged["importance"] = _importance(model, properties, wanted, inside & held, random)
    crests = native.load().crests_of(model.probabilities(properties))
    threshold = _threshold(crests, drawings, ~held, tolerance)
    judged |= measures(native.load().lines_of(crests, threshold), drawings, held, tolerance)
    model = model.with_threshold(threshold)
    return Learned(model, judged | {"kind": kind, "tolerance_px": tolerance, "threshold": threshold})


def drawn(model, properties, threshold=None):
    """(probability, lines) of a LineModel: (H, W) float32, and the native Bitmap of lines from a threshold on, its own
    if None is given."""
    core, probability = native.load(), model.probabilities(properties)
    return probability, core.lines_of(core.crests_of(probability), model.threshold if threshold is None else threshold)


def _samples(properties, wanted, where, random):
    """(rows, target, weight) of all pixels near to lines, and of some others, that stand for the rest."""
    near, others = np.flatnonzero(where & (wanted >= NEAR)), np.flatnonzero(where & (wanted < NEAR))
    most = MOST // (1 + OTHERS)
    parts = _some(near, most, random), _some(others, max(OTHERS * min(len(near), most), most), random)
    stand_for = [len(all_of) / max(1, len(part)) for all_of, part in zip((near, others), parts)]
    weight = np.repeat(np.float32(stand_for), [len(part) for part in parts])
    chosen = np.concatenate(parts)
    return *_of(properties, wanted, chosen), weight


def _some(numbers, most, random):
    return numbers if len(numbers) <= most else np.sort(random.choice(numbers, most, replace=False))


def _of(properties, wanted, chosen):
    values = properties.values
    return values.reshape(-1, values.shape[2])[chosen], wanted.ravel()[chosen]


def _judged(model, properties, wanted, where):
    """Figures of a model at pixels that it has not learned from; None where these are alike."""
    chosen = np.flatnonzero(where)
    rows, target = _of(properties, wanted, chosen)
    found = {"pixels": len(chosen), "r2": None, "auc": None}
    if len(chosen) < 2 or np.ptp(target) == 0:
        return found
    values = model.values(rows)
    found["r2"] = float(1 - np.mean((values - target) ** 2, dtype=float) / np.var(target, dtype=float))
    found["auc"] = auc(values, target >= LIKELY)
    return found


def _importance(model, properties, wanted, where, random):
    """{property: importance} by pixels that a model has not learned from, the most important one first; empty where
    these are alike."""
    rows, target = _of(properties, wanted, _some(np.flatnonzero(where), MOST_JUDGED, random))
    if len(target) < 2 or np.ptp(target) == 0:
        return {}
    found = model.importance(rows, target, np.ones(len(target), np.float32))
    return dict(sorted(found.items(), key=lambda item: -item[1]))


def auc(values, is_line):
    """The share of pairs of a pixel of a line and another one of which the first has the higher value; equal ones count
    half. None where there are no such pairs."""
    lines, others = int(is_line.sum()), int((~is_line).sum())
    if not lines or not others:
        return None
    _, number, counts = np.unique(values, return_inverse=True, return_counts=True)
    ranks = np.cumsum(counts) - (counts - 1) / 2
    return float((ranks[number][is_line].sum() - lines * (lines + 1) / 2) / (lines * others))


def measures(lines, drawings, where, tolerance):
    """{precision, recall, f1}, means of a Bitmap of lines judged by others, of the pixels `where` (H, W) bool; as
    comparisons have them, but 0 where there are no pixels."""
    to_lines, all_of = lines.distances(), []
    for drawing in drawings:
        drawn, wanted = (where & (bitmap.pixels > 0) for bitmap in (lines, drawing))
        near = [(d[at] <= tolerance).mean() if at.any() else 0 for d, at in
                ((drawing.distances(), drawn), (to_lines, wanted))]  # fmt: skip
        all_of.append([*near, 2 * near[0] * near[1] / max(sum(near), 1e-9)])
    return dict(zip(("precision", "recall", "f1"), map(float, np.mean(all_of, axis=0))))


def _threshold(crests, drawings, where, tolerance):
    """The threshold of the lines that are most like the drawings at pixels `where`."""
    best, most = LIKELY, 0.0
    for threshold in map(float, THRESHOLDS):
        lines = native.load().lines_of(crests, threshold)
        if not lines.pixels.any():
            break
        f1 = measures(lines, drawings, where, tolerance)["f1"]
        if f1 > most:
            best, most = round(threshold, 4), f1
    return best
