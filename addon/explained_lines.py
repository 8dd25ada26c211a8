# SPDX-License-Identifier: GPL-3.0-or-later
"""Which line definitions explain a drawing: precision-recall curves, and each pixel's definitions at a fixed precision.
Cole 2009, section 3.2.2. Without Blender."""

from collections import Counter
from dataclasses import dataclass

import numpy as np

PRECISION = 0.8  # at which definitions are compared in combination
PRECISIONS = np.linspace(0, 1, 51)  # of curves


@dataclass(frozen=True)
class Definition:
    """Visible lines of a definition in the judges' picture. `strengths`: native Strengths; `always`: the native Bitmap
    of contours that are drawn with them."""

    strengths: object
    always: object
    in_image: bool


def explain(definitions, outer, contours, judges, tolerance):
    """A dict of how {name: Definition} explain the Bitmaps `judges`: precisions, and of each definition its mean recall
    there (`curves`); `explained`, shares of all judges' pixels at PRECISION; `contours`: [{precision, recall}] of
    contours alone, for each judge; and with several judges the curve of the best drawing that there is of them.
    `outer`, `contours`: Bitmaps of outer boundaries and all contours; `tolerance` [px]."""
    curves = {
        name: [definition.strengths.curve(definition.always, judge, tolerance) for judge in judges]
        for name, definition in definitions.items()
    }
    alone = [contours.measures(judge, tolerance) for judge in judges]
    found = {
        "precisions": PRECISIONS.tolist(),
        "curves": {name: _mean_curve(of_judges) for name, of_judges in curves.items()},
        "contours": [{name: measures[name] for name in ("precision", "recall")} for measures in alone],
        "explained": _explained(definitions, curves, outer, contours, judges, tolerance),
    }
    return found | ({"best": best_curve(judges, tolerance)} if len(judges) > 1 else {})


def _mean_curve(curves):
    """Mean recall of several judges at equal precision, and the area below it from 0.5 to 1."""
    recall = np.mean([[curve.recall_at(precision) for precision in PRECISIONS] for curve in curves], axis=0)
    return {"recall": recall.tolist(), "area": float(np.mean([curve.area for curve in curves]))}


def best_curve(judges, tolerance):
    """[{precision, recall}] of drawings that no other has more recall than, of the same precision: all pixels that are
    near to at least so many of the judges."""
    near = [judge.distances() <= tolerance for judge in judges]
    overlap = np.sum(near, axis=0)
    points = [{"precision": 1.0, "recall": 0.0}]
    for least in range(len(judges), 0, -1):
        drawn = type(judges[0])(overlap >= least)
        if drawn.pixels.any():
            precision = overlap[overlap >= least].mean() / len(judges)
            recall = np.mean([drawn.measures(judge, tolerance)["recall"] for judge in judges])
            points.append({"precision": float(precision), "recall": float(recall)})
    return points


def _explained(definitions, curves, outer, contours, judges, tolerance):
    """Shares of the judges' pixels, by what is near: `by_source`, surfaces or the image or both or none of them;
    `by_lines`, the outer boundary, else other contours, else other lines of surfaces, or nothing; `others`, of those
    other lines, by the names of their definitions."""
    source, lines, others = Counter(), Counter(), Counter()
    for number, judge in enumerate(judges):
        at = judge.pixels > 0
        near = {name: _near(_at_precision(d, curves[name][number]), tolerance, at) for name, d in definitions.items()}
        of_outer, of_contours = (_near(bitmap, tolerance, at) for bitmap in (outer, contours))
        none = np.zeros(at.sum(), bool)
        of_surface = {name: near[name] for name, d in definitions.items() if not d.in_image}
        in_image = np.any([none, *(near[name] for name, d in definitions.items() if d.in_image)], axis=0)
        other = np.any([none, *of_surface.values()], axis=0)
        surface = of_contours | of_outer | other
        source.update(_counts(("none", "surface", "image", "both"), surface + 2 * in_image))
        rank = np.select([of_outer, of_contours, other], [0, 1, 2], 3)
        lines.update(_counts(("outer", "contours", "others", "none"), rank))
        names = list(of_surface)
        codes = sum((of_surface[name][rank == 2].astype(int) << i for i, name in enumerate(names)), 0)
        others.update(np.atleast_1d(codes).tolist() if names else ())
    total = max(1, sum(source.values()))
    told = {" + ".join(name for i, name in enumerate(names) if code >> i & 1): n for code, n in others.most_common()}
    return {
        "precision": PRECISION,
        "by_source": _shares(source, total),
        "by_lines": _shares(lines, total),
        "others": _shares(told, total),
    }


def _at_precision(definition, curve):
    """The Bitmap of a definition's own lines at PRECISION; empty where it does not reach that."""
    best = curve.best_at(PRECISION)
    return definition.strengths.above(float(curve.threshold[best]) if best >= 0 else np.inf)


def _near(bitmap, tolerance, at):
    return bitmap.distances()[at] <= tolerance


def _counts(names, codes):
    return Counter(dict(zip(names, np.bincount(codes, minlength=len(names)).tolist())))


def _shares(counts, total):
    return {name: count / total for name, count in counts.items()}
