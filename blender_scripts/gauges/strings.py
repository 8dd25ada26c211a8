# SPDX-License-Identifier: GPL-3.0-or-later
"""Strings of gauges: places close to each other along a line, of which the settings tell how a surface bends there, and
its profile. They are not fitted: a small patch tells no relief (Cole 2009, 4.3, figure 4.9).

Lengths are pixels of the picture; along a string, and towards the viewer."""

from dataclasses import dataclass

import numpy as np

from .formulas import angles


@dataclass(frozen=True)
class OfString:
    """What people see along a string in one style; NaN where nobody has set a gauge."""

    settings: int
    medians: np.ndarray  # (n, 3)
    errors: np.ndarray  # (n,) degrees of the medians from the truth
    apart: np.ndarray  # (n,) degrees: median distance of settings from their median
    profile: np.ndarray  # (n,)
    curvature: np.ndarray  # (n - 1,) between gauges

    def told(self):
        listed = {name: _listed(getattr(self, name)) for name in ("errors", "apart", "profile", "curvature")}
        return {"settings": self.settings, "error": float(np.nanmean(self.errors)), **listed}


def _listed(values):
    return [round(float(value), 6) if np.isfinite(value) else None for value in values]


def line(places):
    """(direction (2,) with y up, spacing) of a string's places."""
    along = (places[-1] - places[0]) * (1, -1)
    length = np.linalg.norm(along)
    return along / length, length / (len(places) - 1)


def profile(normals, along, spacing):
    """(n,) how much nearer to the viewer than at the first place the surface with these normals is, by their slopes."""
    slope = -(normals[:, :2] @ along) / normals[:, 2]
    return np.concatenate([[0.0], np.cumsum(spacing * (slope[1:] + slope[:-1]) / 2)])


def curvature(normals, along, spacing):
    """(n - 1,) how fast normals turn between gauges, per pixel of the profile's length; above 0 where it is convex."""
    turned = np.diff(np.arctan2(normals[:, :2] @ along, normals[:, 2]))
    return turned / np.hypot(spacing, np.diff(profile(normals, along, spacing)))


def of_study(study, gauge, normals):
    """An OfString of each string of a study, of all settings that count, or None where there are none."""
    found = []
    for first, end in study.strings:
        own = [normals[gauge == number] for number in range(first, end)]
        found.append(_of_string(study.places[first:end], study.truth[first:end], own) if any(map(len, own)) else None)
    return found


def _of_string(places, truth, own):
    medians, apart = np.full((len(own), 3), np.nan), np.full(len(own), np.nan)
    for number, settings in enumerate(own):
        if len(settings):
            between = angles(settings[:, None], settings[None])
            at = between.sum(axis=1).argmin()
            medians[number], apart[number] = settings[at], np.median(between[at])
    how = line(places)
    shape = profile(medians, *how), curvature(medians, *how)
    return OfString(sum(map(len, own)), medians, angles(medians, truth), apart, *shape)


def told(study):
    """Of each string its gauges, how far they are apart, and its true profile and curvature."""
    return [
        {
            "gauges": [first, end],
            "spacing": round(float(line(study.places[first:end])[1]), 6),
            "profile": _listed(profile(study.truth[first:end], *line(study.places[first:end]))),
            "curvature": _listed(curvature(study.truth[first:end], *line(study.places[first:end]))),
        }
        for first, end in study.strings
    ]
