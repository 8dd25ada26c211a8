# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies of several scenes in one table, a row for each scene and a column for each style, as 4.1 and 4.2 of Cole 2009
are."""

from collections import Counter
from dataclasses import dataclass
from html import escape

import numpy as np

from . import report
from .analysis import MEASURES, compared, spread_of
from .analysis import told as told_of_one

ALL = "all"  # the row of all scenes together
LABELS = {
    "errors": "degrees from the truth",
    "fitted_errors": "the same, after the fit",
    "from_median": "degrees from the median",
    "fitted_from_median": "the same, after the fit",
}
BLIND = "blind"  # the column of gauges that are set without looking


@dataclass(frozen=True)
class _Aligned:
    """Errors of a style over some scenes, less what is of the scenes, as analysis.compared takes them."""

    fitted_errors: np.ndarray
    sessions: list


@dataclass(frozen=True)
class _Session:
    fitted_errors: np.ndarray


def check(studies):
    """ValueError if two of the studies are the same one."""
    seen = {}
    for study in studies:
        if study.name in seen:
            raise ValueError(f"{seen[study.name]} and {study.folder} are the same study: name each once")
        seen[study.name] = study.folder


def told(analyses):
    """A dict of the figures of several Analyses: of each `scenes`, its own, with the `name` of its row; `rows`: for
    each measure one per scene and one of all, where a style has settings in every scene; `p_values` of all scenes."""
    names = _names(analyses)
    styles = list(dict.fromkeys(style for analysis in analyses for style in analysis.styles))
    return {
        "scenes": [told_of_one(analysis) | {"name": name} for analysis, name in zip(analyses, names)],
        "styles": styles,
        "rows": {measure: _rows(analyses, names, styles, measure) for measure in MEASURES},
        "p_values": [
            {"styles": [a, b], **compared(*pair)}
            for i, a in enumerate(styles) for b in styles[i + 1 :] if (pair := _aligned(analyses, a, b))
        ],
    }  # fmt: skip


def _names(analyses):
    """Of scenes; with their folders where two have the same."""
    count = Counter(analysis.study.model for analysis in analyses)
    return [
        a.study.model if count[a.study.model] == 1 else f"{a.study.model} ({a.study.folder.name})" for a in analyses
    ]


def _rows(analyses, names, styles, measure):
    of_scenes = [{style: _values(analysis.styles.get(style), measure) for style in styles} for analysis in analyses]
    blind = [analysis.floors["random"].get(measure, np.empty(0)) for analysis in analyses]
    rows = [(name, *row) for name, row in zip(names, zip(of_scenes, blind))]
    rows.append((ALL, {style: _joined([row[style] for row in of_scenes]) for style in styles}, _joined(blind)))
    return [
        {"scene": name, "styles": {style: spread_of(values) for style, values in row.items()}, BLIND: spread_of(floor)}
        for name, row, floor in rows
    ]


def _values(found, measure):
    return np.empty(0) if found is None else getattr(found, measure)


def _joined(of_scenes):
    """Those of all scenes; none where a scene has none: it would be easier or harder than the others."""
    return np.concatenate(of_scenes) if all(map(len, of_scenes)) else np.empty(0)


def _aligned(analyses, a, b):
    """The _Aligned of two styles by the scenes that both have settings of; None if there are none. From errors of a
    scene the mean of both styles' means is taken off, so that a hard scene tells nothing for or against the style that
    has more settings of it."""
    both = [[analysis.styles[style] for style in (a, b)] for analysis in analyses if {a, b} <= set(analysis.styles)]
    both = [pair for pair in both if all(len(found.gauge) for found in pair)]
    if not both:
        return None
    levels = [np.mean([found.fitted_errors.mean() for found in pair]) for pair in both]
    return [
        _Aligned(
            np.concatenate([pair[k].fitted_errors - level for pair, level in zip(both, levels)]),
            [_Session(s.fitted_errors - level) for pair, level in zip(both, levels) for s in pair[k].sessions],
        )
        for k in (0, 1)
    ]


def text(figures):
    """Tables of mean errors in degrees, and who was refused."""
    lines = []
    for measure in ("fitted_errors", "fitted_from_median"):
        label = f"{_long(measure)}, after the fit"
        lines.append(f"{label:44}" + "".join(f"{name[:12]:>13}" for name in (*figures["styles"], BLIND)))
        for row in figures["rows"][measure]:
            cells = [_cell(value, "+-") for value in (*row["styles"].values(), row[BLIND])]
            lines.append(f"{row['scene'][:43]:44}" + "".join(f"{cell:>13}" for cell in cells))
    for scene in figures["scenes"]:
        lines += [f"{scene['name']}, {line}" for line in report.refused(scene)]
    return "\n".join(lines)


def _long(measure):
    return LABELS[measure.removeprefix("fitted_")]


def _cell(value, between):
    return "-" if value is None else f"{value['mean']:.1f} {between} {value['sd']:.1f}"


def page(analyses, figures):
    """The text of an HTML page about several Analyses; `figures`: what they tell."""
    title = f"Gauges on {len(analyses)} scenes"
    body = [
        f"<h1>{escape(title)}</h1>",
        "<p>Mean and standard deviation of all settings of a scene. The last row is of styles that have settings in "
        "every scene, the last column of gauges that are set without looking.</p>",
    ]
    for measure, label in LABELS.items():
        rows = [
            (row["scene"], *(_cell(value, "±") for value in (*row["styles"].values(), row[BLIND])))
            for row in figures["rows"][measure]
        ]
        body.append(report.table([(label, *figures["styles"], BLIND), *rows]))
    body.append(report.compared(figures["p_values"], figures["styles"]))
    for analysis, scene in zip(analyses, figures["scenes"]):
        body += report.parts(analysis, scene | {"model": scene["name"]})
    return report.document(title, body)
