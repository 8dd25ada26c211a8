# SPDX-License-Identifier: GPL-3.0-or-later
"""An analysis in words, and as a page: tables as 4.1 and 4.2 of Cole 2009, how errors are distributed, and medians of
gauges on the pictures, by their errors. The page is one HTML file that needs no others."""

import base64
from html import escape

import numpy as np

from . import formulas, string_report
from .analysis import SAME

MEASURES = {
    "errors": "from the truth",
    "fitted_errors": "the same, after the fit",
    "from_median": "from the median",
    "fitted_from_median": "the same, after the fit",
}
FLOORS = {"random": "set blindly", "facing": "all to the viewer"}
# Colors of errors, and the degrees from which on they are the last one's.
STOPS, WORST = np.array([(30, 90, 200), (60, 180, 120), (240, 190, 50), (220, 50, 30)]), 60.0
STYLE = """body{font:15px/1.45 sans-serif;max-width:1100px;margin:2em auto;padding:0 1em;color:#222}
table{border-collapse:collapse;margin:1em 0}td,th{padding:.2em .9em;text-align:right;border-bottom:1px solid #ddd}
th:first-child,td:first-child{text-align:left}td.same{background:#222;color:#fff}figure{margin:1.5em 0}
figure.small{display:inline-block;margin-right:1.5em}
svg{max-width:100%;border:1px solid #ccc}svg text{font:12px sans-serif}"""
BINS, WIDTH, HEIGHT, ROUND = 18, 360, 160, 240  # of histograms, and of round plots
MOST_DOTS = 1000


def text(told):
    """A table of mean errors in degrees, and who was refused."""
    head = f"{'degrees':24}" + "".join(f"{name[:12]:>13}" for name in (*told["styles"], "blind"))
    lines = [f"{told['model']}: {told['gauges']} gauges", head]
    for key, label in MEASURES.items():
        values = [style[key] for style in told["styles"].values()] + [told["floors"]["random"].get(key)]
        cells = ("-" if value is None else f"{value['mean']:.1f} +- {value['sd']:.1f}" for value in values)
        lines.append(f"{label:24}" + "".join(f"{cell:>13}" for cell in cells))
    counts = [f"{len(style['sessions']) - style['refused']}" for style in told["styles"].values()]
    lines.append(f"{'sessions that count':24}" + "".join(f"{count:>13}" for count in counts))
    return "\n".join([*lines, *string_report.text(told), *refused(told)])


def refused(told):
    """A line for each session that does not count."""
    return [
        f"{name}: session {each['session']} of {each['participant']} does not count: {each['refused']}"
        for name, style in told["styles"].items() for each in style["sessions"] if each["refused"]
    ]  # fmt: skip


def page(analysis, told):
    """The text of an HTML page about an Analysis; `told`: its figures."""
    return document(f"Gauges on {told['model']}", parts(analysis, told))


def document(title, body):
    head = f'<meta charset="utf-8"><title>{escape(title)}</title><style>{STYLE}</style>'
    return f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n<body>\n' + "\n".join(body) + "\n</body></html>\n"


def parts(analysis, told):
    """What a page has about an Analysis."""
    study, counted = analysis.study, {s: found for s, found in analysis.styles.items() if len(found.gauge)}
    return [
        f"<h1>{escape('Gauges on ' + told['model'])}</h1>",
        "<p>Degrees between the normals that people see and the true ones, or the median of what people see; after the "
        "fit: of each session in the bas-relief that brings it nearest to the truth. The last columns are of gauges "
        "that are set without looking.</p>",
        _errors(told),
        compared(told["p_values"], list(counted)),
        *(_of_style(study, name, found) for name, found in counted.items()),
        *string_report.parts(study, analysis.styles, gauge, color),
        "<h2>Sessions</h2>",
        _sessions(told),
    ]


def table(rows):
    """Of rows of texts; a text that begins with ! is marked."""

    def cell(words):
        marked = str(words).startswith("!")
        return f"<td{' class=same' if marked else ''}>{escape(str(words).removeprefix('!'))}</td>"

    lines = ("".join(map(cell, row)) for row in rows)
    return "<table>" + "".join(f"<tr>{line}</tr>" for line in lines) + "</table>"


def _number(value, pattern="{:.1f}"):
    return "-" if value is None else pattern.format(value)


def _errors(told):
    rows = [("mean, standard deviation", *told["styles"], *FLOORS.values())]
    for key, label in MEASURES.items():
        of_all = [style[key] for style in told["styles"].values()] + [told["floors"][name].get(key) for name in FLOORS]
        rows.append((label, *("-" if each is None else f"{each['mean']:.1f} ± {each['sd']:.1f}" for each in of_all)))
    rows.append(("settings", *(style["settings"] for style in told["styles"].values()), "", ""))
    return table(rows)


def compared(p_values, styles):
    """p values of every two styles; those that are not told apart are marked."""
    if len(styles) < 2:
        return ""
    values = {tuple(each["styles"]): each for each in p_values}

    def cell(a, b, key):
        value = (values.get((a, b)) or values.get((b, a)) or {}).get(key)
        return "" if a == b else ("!" if value is not None and value > SAME else "") + _number(value, "{:.2g}")

    found = ["<h2>Are styles told apart?</h2><p>Rank sum tests of errors after the fit: the probability of differences "
             f"like these by chance. Dark: above {SAME}.</p>"]  # fmt: skip
    for key, label in (("by_setting", "of settings"), ("by_session", "of means of sessions, which are independent")):
        found.append(table([(label, *styles), *((a, *(cell(a, b, key) for b in styles)) for a in styles)]))
    return "".join(found)


def _sessions(told):
    rows = [("participant", "session", "picture", "settings", "alike twice", "spread", "depth seen", "slope seen",
             "error", "after the fit", "seconds a gauge", "counts")]  # fmt: skip
    for style, found in told["styles"].items():
        for each in found["sessions"]:
            slope = " ".join(f"{value:+.2f}" for value in each["slope"] or ())
            rows.append((
                each["participant"], each["session"], style, each["settings"], _number(each["near"], "{:.0%}"),
                _number(each["spread"]), _number(each["depth"], "{:.2f}"), slope, _number(each["error"]),
                _number(each["fitted_error"]), _number(each["seconds"]), each["refused"] or "yes",
            ))  # fmt: skip
    return table(rows)


def _of_style(study, style, found):
    errors = formulas.angles(found.fitted_medians, study.truth)
    caption = "Medians of what people see, after the fit; blue: near the truth, red: 60 degrees and more from it"
    around = "by the direction on the picture, in equal areas; rings: 30, 60 and 90 degrees from the truth"
    return "".join([
        f"<h2>{escape(style)}</h2>",
        _captioned(_picture(study, style, found.fitted_medians, errors), caption),
        _histogram(found.errors, found.fitted_errors, "from the truth; line: before the fit"),
        _histogram(found.from_median, found.fitted_from_median, "from the median; line: before the fit"),
        _round(_around(found.fitted, study.truth[found.gauge]), around),
    ])  # fmt: skip


def color(error):
    """The color of an error in degrees, as of SVG."""
    at = min(max(error / WORST, 0.0), 1.0) * (len(STOPS) - 1)
    below = min(int(at), len(STOPS) - 2)
    return "rgb({} {} {})".format(*np.rint(STOPS[below] + (at - below) * (STOPS[below + 1] - STOPS[below])).astype(int))


def _picture(study, style, normals, errors):
    """A stimulus with gauges on it; those that nobody set are left out."""
    width, height = study.size
    png = base64.b64encode((study.folder / study.stimuli[style]["file"]).read_bytes()).decode()
    set_ones = np.flatnonzero(np.isfinite(errors))
    drawn = "".join(gauge(study.places[i], normals[i], study.radius, color(errors[i]), errors[i]) for i in set_ones)
    image = f'<image href="data:image/png;base64,{png}" width="{width}" height="{height}"/>'
    return f'<svg viewBox="0 0 {width} {height}" width="{width}">{image}{drawn}</svg>'


def gauge(place, n, radius, stroke, error=None):
    """A gauge as SVG, with its error as a title."""
    major, minor, angle, pin = formulas.ellipse(n, radius)
    told = "" if error is None else f"<title>{error:.0f} degrees</title>"
    return (
        f'<g transform="translate({place[0]:.1f} {place[1]:.1f})" fill="none" stroke="{stroke}" stroke-width="2.5">'
        f'{told}<ellipse rx="{minor:.2f}" ry="{major:.2f}" transform="rotate({-np.degrees(angle):.2f})"/>'
        f'<line x2="{pin[0]:.2f}" y2="{-pin[1]:.2f}"/></g>'
    )


def _histogram(before, after, caption):
    """Shares of settings by their error, 0 to 90 degrees, larger ones with the last."""
    edges = np.linspace(0, 90, BINS + 1)
    first, last = (np.histogram(np.minimum(errors, 89.9), edges)[0] / len(errors) for errors in (before, after))
    most = max(first.max(), last.max())
    step = WIDTH / BINS
    bars = "".join(
        f'<rect x="{i * step:.1f}" y="{HEIGHT * (1 - share / most):.1f}" width="{step - 1:.1f}" '
        f'height="{HEIGHT * share / most:.1f}" fill="#1b6ac9"/>' for i, share in enumerate(last)
    )  # fmt: skip
    line = " ".join(
        f"{x:.1f},{HEIGHT * (1 - share / most):.1f}"
        for i, share in enumerate(first) for x in (i * step, (i + 1) * step)
    )  # fmt: skip
    ends = (
        f'<text x="0" y="{HEIGHT + 16}">0</text><text x="{WIDTH}" y="{HEIGHT + 16}" text-anchor="end">90 degrees</text>'
    )
    drawn = f'{bars}<polyline points="{line}" fill="none" stroke="#222"/>{ends}'
    quarter = f"{np.quantile(after, 0.75):.0f}"
    svg = f'<svg viewBox="0 -4 {WIDTH} {HEIGHT + 26}" width="{WIDTH}">{drawn}</svg>'
    return _captioned(svg, f"{caption}; three quarters are within {quarter} degrees", " class=small")


def _around(normals, truth):
    """(n, 2) in which direction normals are off, x to the right and y up, by as many degrees as they are."""
    off = (normals - truth)[:, :2]
    length = np.linalg.norm(off, axis=1, keepdims=True)
    return off / np.maximum(length, 1e-9) * formulas.angles(normals, truth)[:, None]


def _round(errors, caption):
    """Errors (n, 2) as dots: the direction in which a setting is off, and how many degrees, in equal areas."""
    middle = ROUND / 2

    def far(degrees):
        return middle * np.sqrt(2) * np.sin(np.radians(np.minimum(degrees, 90)) / 2)

    rings = "".join(
        f'<circle cx="{middle}" cy="{middle}" r="{far(d):.1f}" fill="none" stroke="#999"/>' for d in (30, 60, 90)
    )
    shown = errors[:: max(1, len(errors) // MOST_DOTS)]
    degrees = np.linalg.norm(shown, axis=1, keepdims=True)
    dots = "".join(
        f'<circle cx="{middle + x:.1f}" cy="{middle - y:.1f}" r="1.2" fill="#1b6ac9"/>'
        for x, y in far(degrees) * shown / np.maximum(degrees, 1e-9)
    )
    box = f"-2 -2 {ROUND + 4} {ROUND + 4}"
    return _captioned(f'<svg viewBox="{box}" width="{ROUND}">{rings}{dots}</svg>', escape(caption), " class=small")


def _captioned(figure, caption, kind=""):
    return f"<figure{kind}>{figure}<figcaption>{caption}</figcaption></figure>"
