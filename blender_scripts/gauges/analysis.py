# SPDX-License-Identifier: GPL-3.0-or-later
"""How near the shape that people see in pictures is to the true one: which sessions count, errors before and after the
best relief of each, medians, and what blind settings would have. `core`: the native module. Cole 2009, sections 4.2.4,
4.2.6 and 4.3."""

from dataclasses import dataclass

import numpy as np

from . import observers, rank_sum, strings
from .formulas import angles, sets

NEAR, LEAST_NEAR = 30.0, 0.7  # degrees between both settings of a gauge, and the share that is to be so near
LEAST_SPREAD = 5.0  # degrees: standard deviation of all settings of a session
BLIND = 200  # sessions of which floors are the mean
MEASURES = "errors", "fitted_errors", "from_median", "fitted_from_median"  # of an OfStyle, in degrees
SAME = 0.05  # p values above it: styles are not told apart


@dataclass(frozen=True)
class Judged:
    """A Session, and whether it counts."""

    session: object
    near: float | None  # share of gauges whose settings are near each other; None: none was set twice
    spread: float  # degrees
    relief: object  # native BasRelief: how it sees the surface
    errors: np.ndarray  # (n,) degrees from the truth
    fitted: np.ndarray  # (n, 3) settings, in the relief that brings them nearest to the truth
    fitted_errors: np.ndarray  # (n,) degrees
    of_strings: bool  # its gauges are those of strings: they are not fitted
    truth_spread: float  # degrees, of the true normals of its gauges

    @property
    def refused(self):
        """Why it does not count; "": it does."""
        if self.near is None:
            return "no gauge was set twice"
        if self.near < LEAST_NEAR:
            return f"only {self.near:.0%} of the gauges were set alike twice"
        flat = self.of_strings and self.truth_spread < 2 * LEAST_SPREAD
        alike = self.spread < LEAST_SPREAD and not flat
        return f"all settings are alike, within {self.spread:.1f} degrees" if alike else ""


def judged(core, study, session):
    truth = study.truth[session.gauge]
    of_strings = bool((session.gauge >= study.even).all())
    enough = len(truth) >= 3 and not of_strings  # a small patch tells no relief of a whole
    fitted = core.BasRelief.fitted(session.normals, truth).of_normals(session.normals) if enough else session.normals
    # Noise is in the settings. Fitted to the truth it would flatten the relief; the other way round it does not.
    relief = core.BasRelief.fitted(truth, session.normals) if enough else core.BasRelief()
    errors, fitted_errors = angles(session.normals, truth), angles(fitted, truth)
    near, alike = near_share(session), spread(session.normals)
    return Judged(session, near, alike, relief, errors, fitted, fitted_errors, of_strings, spread(truth))


def near_share(session):
    """Share of the gauges that were set twice whose settings are near each other; None: there are none."""
    first, second = (
        {g: n for g, r, n in zip(session.gauge, session.repeat, session.normals) if r == k} for k in (0, 1)
    )
    both = [gauge for gauge in first if gauge in second]
    if not both:
        return None
    apart = angles(np.array([first[gauge] for gauge in both]), np.array([second[gauge] for gauge in both]))
    return float((apart <= NEAR).mean())


def spread(normals):
    """Degrees: standard deviation of normals about their mean."""
    mean = normals.mean(axis=0)
    return float(np.sqrt((angles(normals, mean / np.linalg.norm(mean)) ** 2).mean()))


def median(normals):
    """(3,) the one of several normals with the least sum of angles to the others."""
    return normals[angles(normals[:, None], normals[None]).sum(axis=1).argmin()]


def medians(normals, gauge, count):
    """(count, 3) medians of the settings of each gauge; NaN where there is none."""
    found = np.full((count, 3), np.nan)
    for number in np.unique(gauge):
        found[number] = median(normals[gauge == number])
    return found


@dataclass(frozen=True)
class OfStyle:
    """All settings that count of a style; those of strings in `strings` alone."""

    sessions: list  # of Judged that count, of gauges that are spread evenly
    refused: list  # of those that do not
    gauge: np.ndarray  # (n,)
    fitted: np.ndarray  # (n, 3)
    errors: np.ndarray  # (n,) degrees from the truth
    fitted_errors: np.ndarray  # the same after the fit
    from_median: np.ndarray  # (n,) degrees from the median of the gauge
    fitted_from_median: np.ndarray
    medians: np.ndarray  # (gauges, 3), as set; NaN: none
    fitted_medians: np.ndarray
    of_strings: list  # of Judged that count
    strings: list  # a strings.OfString of each string, or None


def of_style(study, every):
    """The OfStyle of a style's Judged."""
    counted = [each for each in every if not each.refused]
    kept, of_strings = ([each for each in counted if each.of_strings == which] for which in (False, True))

    def joined(of, empty, kept=kept):
        return np.concatenate([empty, *map(of, kept)])

    none, vectors = np.empty(0), np.empty((0, 3))
    gauge = joined(lambda each: each.session.gauge, np.empty(0, np.intp))
    normals = joined(lambda each: each.session.normals, vectors)
    fitted = joined(lambda each: each.fitted, vectors)
    as_set, after = (medians(found, gauge, len(study.truth)) for found in (normals, fitted))
    return OfStyle(
        kept, [each for each in every if each.refused], gauge, fitted,
        joined(lambda each: each.errors, none), joined(lambda each: each.fitted_errors, none),
        angles(normals, as_set[gauge]), angles(fitted, after[gauge]), as_set, after, of_strings,
        strings.of_study(
            study, joined(lambda each: each.session.gauge, np.empty(0, np.intp), of_strings),
            joined(lambda each: each.session.normals, vectors, of_strings),
        ),
    )  # fmt: skip


def floors(core, truth, seed=1):
    """{"random" and "facing": {"errors" and "fitted_errors": (n,) degrees}} of blind settings: of every direction that
    faces the viewer, and straight to the viewer, in sessions as people have them."""
    random, parts = np.random.default_rng(seed), sets(len(truth))
    found = {"random": ([], []), "facing": ([], [])}
    for number in range(BLIND):
        shown = np.tile(truth[parts[number % len(parts)]], (2, 1))
        blind = {"random": observers.anywhere(random, len(shown))}
        if number < len(parts):
            blind["facing"] = np.tile([0.0, 0.0, 1.0], (len(shown), 1))
        for name, settings in blind.items():
            fitted = core.BasRelief.fitted(settings, shown).of_normals(settings)
            found[name][0].append(angles(settings, shown))
            found[name][1].append(angles(fitted, shown))
    return {name: dict(zip(("errors", "fitted_errors"), map(np.concatenate, both))) for name, both in found.items()}


@dataclass(frozen=True)
class Analysis:
    study: object
    styles: dict  # style -> OfStyle
    floors: dict


def analyse(core, study, sessions):
    """The Analysis of a study's Sessions."""
    every = {style: [] for style in study.stimuli}
    for session in sessions:
        every[session.style].append(judged(core, study, session))
    return Analysis(
        study, {s: of_style(study, found) for s, found in every.items()}, floors(core, study.truth[: study.even])
    )


def told(analysis):
    """A dict of an Analysis's figures; degrees."""
    counted = {style: found for style, found in analysis.styles.items() if len(found.gauge)}
    return {
        "study": analysis.study.name,
        "model": analysis.study.model,
        "gauges": analysis.study.even,
        "strings": strings.told(analysis.study),
        "styles": {style: _told_of_style(found) for style, found in analysis.styles.items()},
        "floors": {
            name: {key: spread_of(values) for key, values in each.items()} for name, each in analysis.floors.items()
        },
        "p_values": [
            {"styles": [a, b], **compared(counted[a], counted[b])}
            for i, a in enumerate(counted) for b in list(counted)[i + 1 :]
        ],
    }  # fmt: skip


def _told_of_style(found):
    measures = {name: spread_of(getattr(found, name)) for name in MEASURES}
    sessions = [_told_of_session(each) for each in (*found.sessions, *found.of_strings, *found.refused)]
    told = {"settings": len(found.gauge), "refused": len(found.refused), **measures, "sessions": sessions}
    return told | {"strings": [each and each.told() for each in found.strings]}


def _told_of_session(each):
    session = each.session
    return {
        "participant": session.participant, "session": session.number, "settings": len(session.gauge),
        "refused": each.refused, "near": each.near, "spread": each.spread, "of_strings": each.of_strings,
        "depth": None if each.of_strings else each.relief.depth,
        "slope": None if each.of_strings else list(each.relief.slope), "error": float(each.errors.mean()),
        "fitted_error": float(each.fitted_errors.mean()), "seconds": float(np.median(session.seconds)),
    }  # fmt: skip


def spread_of(values):
    """Mean, standard deviation, median and third quartile; None where there are no values."""
    if not len(values):
        return None
    middle, most = np.quantile(values, (0.5, 0.75))
    return {
        "mean": float(values.mean()),
        "sd": float(values.std()),
        "median": float(middle),
        "three_quarters": float(most),
    }


def compared(a, b):
    """p values of two styles' errors after the fit: by settings, as the thesis has them, and by the means of sessions,
    as settings of one person are not independent."""
    by_session = ([float(each.fitted_errors.mean()) for each in found.sessions] for found in (a, b))
    return {
        "by_setting": rank_sum.p_value(a.fitted_errors, b.fitted_errors),
        "by_session": rank_sum.p_value(*by_session),
    }
