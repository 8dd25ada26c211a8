# SPDX-License-Identifier: GPL-3.0-or-later
"""Strings of gauges in words and on a page: medians on the picture, near by, and profiles and curvature of what people
see in each style beside the true ones, as figure 4.9 of Cole 2009."""

import base64
from html import escape
from itertools import cycle

import numpy as np

from . import strings

COLORS = "#1b6ac9", "#c43c2f", "#2b8a3e", "#8b4fb3", "#b07a10", "#0e8f8f"  # of styles
AROUND = 2.5  # radii of a gauge around a string
WIDTH, HEIGHT = 360, 170


def text(told):
    """A line for each string and style: the mean error of its medians, and how far settings are from them."""
    return [
        f"string {number + 1}, {name}: medians {found['error']:.1f} degrees off, {found['settings']} settings"
        for number in range(len(told["strings"])) for name, style in told["styles"].items()
        if (found := style["strings"][number])
    ]  # fmt: skip


def parts(study, styles, gauge, color):
    """What a page has about strings. `styles`: {style: analysis.OfStyle}; gauge, color: report's."""
    made = []
    for number, (first, end) in enumerate(study.strings):
        seen = {name: found.strings[number] for name, found in styles.items() if found.strings[number]}
        if seen:
            made.append(f"<h2>String {number + 1}</h2>")
            made += [_picture(study, name, first, end, found, gauge, color) for name, found in seen.items()]
            how = strings.line(study.places[first:end])
            made += _charts(study.truth[first:end], how, seen)
    return made


def _picture(study, style, first, end, found, gauge, color):
    """The part of a stimulus around a string, with medians on it."""
    places, (width, height) = study.places[first:end], study.size
    low, high = places.min(axis=0) - AROUND * study.radius, places.max(axis=0) + AROUND * study.radius
    png = base64.b64encode((study.folder / study.stimuli[style]["file"]).read_bytes()).decode()
    drawn = "".join(
        gauge(place, n, study.radius, color(error), error)
        for place, n, error in zip(places, found.medians, found.errors) if np.isfinite(error)
    )  # fmt: skip
    image = f'<image href="data:image/png;base64,{png}" width="{width}" height="{height}"/>'
    box = " ".join(f"{value:.1f}" for value in (*low, *(high - low)))
    caption = f"{escape(style)}: medians, {np.nanmean(found.errors):.0f} degrees off on the average"
    svg = f'<svg viewBox="{box}" width="{WIDTH}">{image}{drawn}</svg>'
    return f"<figure class=small>{svg}<figcaption>{caption}</figcaption></figure>"


def _charts(truth, how, seen):
    """Profiles and curvature along a string."""
    true = strings.profile(truth, *how), strings.curvature(truth, *how)
    names = ", ".join(f'<span style="color:{c}">{escape(name)}</span>' for name, c in zip(seen, cycle(COLORS)))
    for values, key, caption in zip(
        true, ("profile", "curvature"), ("Profile, the viewer above", "Curvature, convex above the line")
    ):
        lines = [("#222", values), *((c, getattr(found, key)) for found, c in zip(seen.values(), cycle(COLORS)))]
        told = f"{caption}; {names}; black: the truth"
        yield f"<figure class=small>{_chart(lines)}<figcaption>{told}</figcaption></figure>"


def _chart(lines):
    """Lines of (color, values) over the same steps; a dotted line at zero."""
    every = np.concatenate([values for _, values in lines])
    low, high = min(0.0, np.nanmin(every)), max(0.0, np.nanmax(every))
    scale = HEIGHT / max(high - low, 1e-12)
    drawn = f'<line x2="{WIDTH}" y1="{high * scale:.1f}" y2="{high * scale:.1f}" stroke="#999" stroke-dasharray="2 4"/>'
    for stroke, values in lines:
        x = np.arange(len(values)) * WIDTH / (len(values) - 1)
        is_known = np.isfinite(values)
        points = " ".join(f"{a:.1f},{(high - b) * scale:.1f}" for a, b in zip(x[is_known], values[is_known]))
        drawn += f'<polyline points="{points}" fill="none" stroke="{stroke}" stroke-width="2"/>'
    return f'<svg viewBox="-3 -3 {WIDTH + 6} {HEIGHT + 6}" width="{WIDTH}">{drawn}</svg>'
