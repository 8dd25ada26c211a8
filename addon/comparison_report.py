# SPDX-License-Identifier: GPL-3.0-or-later
"""Comparisons as pictures and as a page: what one drawing has and the other has not, figures, curves and bars. The page
is one HTML file that needs no others. Without Blender."""

import base64
from html import escape

import numpy as np

from . import files, native

BOTH, ONLY_A, ONLY_B = (150, 150, 150), (20, 70, 230), (225, 25, 25)  # colors of overlays
COLORS = "#1b6ac9", "#d1495b", "#2e8b57", "#8e5bb5", "#c77f12", "#3aa6a6", "#7a6a58", "#b0479d"  # of definitions
NONE_COLOR = "#cccccc"
PLOT = 420, 300  # of curves
MEASURES = {
    "precision": "precision", "recall": "recall", "f1": "F1", "chamfer_px": "chamfer distance [px]",
    "iou": "intersection over union",
}  # fmt: skip
BARS = {
    "by_source": {"surface": "lines of surfaces", "image": "lines of the image", "both": "both", "none": "nothing"},
    "by_lines": {"outer": "outer boundary", "contours": "other contours", "others": "other lines", "none": "nothing"},
}
STYLE = """body{font:15px/1.45 sans-serif;max-width:1100px;margin:2em auto;padding:0 1em;color:#222}
table{border-collapse:collapse}td,th{padding:.2em .9em;text-align:right;border-bottom:1px solid #ddd}
th:first-child,td:first-child{text-align:left}img{max-width:100%;border:1px solid #ccc}
figure{margin:1.5em 0}svg text{font:12px sans-serif}.key{display:inline-block;margin-right:1.2em}
.key i{display:inline-block;width:.9em;height:.9em;margin-right:.4em}"""


def overlay(a, judge, tolerance):
    """(H, W, 3) uint8, bottom row first: pixels of Bitmap a and of the one that judges it, on white; those that are
    within the tolerance [px] of the other gray, else blue (a) or red (judge)."""
    picture = np.full((*a.pixels.shape, 3), 255, np.uint8)
    for bitmap, other, alone in ((judge, a, ONLY_B), (a, judge, ONLY_A)):
        near = other.distances() <= tolerance
        for drawn, color in ((bitmap.pixels > 0) & near, BOTH), ((bitmap.pixels > 0) & ~near, alone):
            picture[drawn] = color
    return picture


def write(compared, path):
    """Writes a comparison.Compared to a file, which is whole or not there: as an HTML page or, by its suffix, the
    overlay with the first judge as a PNG."""
    with files.written(path) as fresh:
        if path.suffix.lower() == ".png":
            picture = overlay(compared.a, compared.judges[0], compared.found["tolerance_px"])
            fresh.write_bytes(native.load().png_bytes(picture))
        else:
            fresh.write_text(page(compared), encoding="utf-8")


def page(compared):
    """The text of an HTML page about a comparison.Compared."""
    names, found = compared.names, compared.found
    overlays = [overlay(compared.a, judge, found["tolerance_px"]) for judge in compared.judges]
    title = f"{names[0]}, judged by {' and '.join(names[1:])}"
    parts = [
        f"<h1>{escape(title)}</h1>",
        f"<p>Lines within {found['tolerance_px']:.2f} pixels of each other count as the same.</p>",
        _table(names[1:], found),
        *(_figure(names[0], judge, picture) for judge, picture in zip(names[1:], overlays)),
        _histogram(found["agreement"], found["tolerance_px"]),
        *(_definitions(found["definitions"]) if "definitions" in found else ()),
    ]
    head = f'<meta charset="utf-8"><title>{escape(title)}</title><style>{STYLE}</style>'
    return f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n<body>\n' + "\n".join(parts) + "\n</body></html>\n"


def _table(judges, found):
    def values(measures):
        return (measures[name] for name in MEASURES)

    rows = [("judged by", *MEASURES.values())]
    rows += [(judge, *map(_number, values(each))) for judge, each in zip(judges, found["judged_by"])]
    at_tolerances = [(f"mean within {each['tolerance_px']:.2f} px", each) for each in found["at_tolerances"]]
    rows += [(name, *map(_number, values(each))) for name, each in at_tolerances]
    lines = [f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in rows]
    return f"<table>{''.join(lines)}</table>"


def _number(value):
    return "-" if value is None or not np.isfinite(value) else f"{value:.3f}"


def _figure(name, judge, picture):
    data = base64.b64encode(native.load().png_bytes(picture)).decode()
    keys = _keys({"both": _hex(BOTH), f"A, {name}, alone": _hex(ONLY_A), f"B, {judge}, alone": _hex(ONLY_B)})
    return _captioned(f'<img alt="overlay" src="data:image/png;base64,{data}">', keys)


def _hex(color):
    return "#" + "".join(f"{value:02x}" for value in color)


def _keys(colors):
    key = '<span class="key"><i style="background:{}"></i>{}</span>'
    return "".join(key.format(color, escape(name)) for name, color in colors.items())


def _histogram(agreement, tolerance):
    """How far pixels are from other drawings, as a curve of shares."""
    distances = agreement["distances_px"]
    x = np.array(distances) / distances[-1]
    at = np.interp(tolerance, distances, agreement["shares"])
    curve = _polyline(x, agreement["shares"], COLORS[0])
    mark = _polyline([tolerance / distances[-1]] * 2, [0, 1], NONE_COLOR)
    caption = f"{agreement['of']}: {at:.0%} of the pixels are within the tolerance of the other drawing"
    return _plot(mark + curve, "distance [px]", "share of pixels", f"{distances[-1]:.0f}", caption)


def _definitions(found):
    """Curves and bars of what line definitions explain."""
    colors = dict(zip(found["curves"], COLORS * len(found["curves"])))
    drawn = [_polyline(curve["recall"], found["precisions"], colors[name]) for name, curve in found["curves"].items()]
    drawn += [_dot(point, "#000000") for point in found["contours"]]
    if "best" in found:
        drawn.append(_polyline(*([p[key] for p in found["best"]] for key in ("recall", "precision")), "#e00000", "4 4"))
    yield "<h2>Line definitions</h2>"
    best = "; dashed: the best that one drawing can do for all" if "best" in found else ""
    yield _plot("".join(drawn), "recall", "precision", "1", f"Black: contours alone{best}")
    areas = {name: curve["area"] for name, curve in found["curves"].items()}
    yield f"<p>{_keys({f'{name} (area {areas[name]:.3f})': color for name, color in colors.items()})}</p>"
    explained = found["explained"]
    yield f"<h2>What explains the lines, at a precision of {explained['precision']:.0%}</h2>"
    for group, names in BARS.items():
        yield _bar({names[key]: share for key, share in explained[group].items()})
    if explained["others"]:
        yield "<p>Other lines, by their definitions:</p>" + _bar(explained["others"])


def _bar(shares):
    colors = {name: NONE_COLOR if name == "nothing" else color for name, color in zip(shares, COLORS * len(shares))}
    x, parts = 0.0, []
    for name, share in shares.items():
        parts.append(f'<rect x="{1000 * x:.1f}" width="{1000 * share:.1f}" height="26" fill="{colors[name]}"/>')
        x += share
    keys = _keys({f"{name} {share:.1%}": colors[name] for name, share in shares.items()})
    return _captioned(f'<svg viewBox="0 0 1000 26" width="100%">{"".join(parts)}</svg>', keys)


def _polyline(x, y, color, dashes="none"):
    width, height = PLOT
    points = " ".join(f"{width * a:.1f},{height * (1 - b):.1f}" for a, b in zip(x, y))
    return f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="2" stroke-dasharray="{dashes}"/>'


def _dot(point, color):
    width, height = PLOT
    x, y = width * point["recall"], height * (1 - point["precision"])
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{color}"/>'


def _plot(drawn, across, up, end, caption):
    width, height = PLOT
    labels = (
        f'<text x="{width / 2}" y="{height + 32}" text-anchor="middle">{across}</text>'
        f'<text x="{width}" y="{height + 16}" text-anchor="end">{end}</text><text x="0" y="{height + 16}">0</text>'
        '<text x="-8" y="10" text-anchor="end">1</text>'
        f'<text transform="translate(-26 {height / 2}) rotate(-90)" text-anchor="middle">{up}</text>'
    )
    frame = f'<rect width="{width}" height="{height}" fill="none" stroke="#999"/>'
    box = f"-40 -8 {width + 60} {height + 48}"
    return _captioned(f'<svg viewBox="{box}" width="{width + 60}">{frame}{labels}{drawn}</svg>', escape(caption))


def _captioned(figure, caption):
    return f"<figure>{figure}<figcaption>{caption}</figcaption></figure>"
