# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures lines that are closer to each other than their spacing.

A sample is crowded if a fully drawn sample of another path, with a direction within ANGLE and offset along the line by
at most a sample's length, is closer than a distance. Excluded are samples within that distance of an end of either run,
or, along the line, of a crossing of the two lines.
"""

import math

import numpy as np

FULL = 0.98  # opacity factor above which a line counts as fully drawn
ANGLE = math.radians(30)
CROSSES = 0.1  # pixels: least change of the signed distance between two lines that counts as a crossing


def nearest_alongside(places, distance):
    """(n,) distance in pixels from each fully drawn sample of Places to the nearest crowding line closer than
    `distance`; inf if there is none."""
    one, other, gap = _pairs(places.px, distance)
    apart = places.path[one] != places.path[other]
    one, other, gap = one[apart], other[apart], gap[apart]
    order = np.lexsort((gap, one, places.run[other], places.run[one]))  # the nearest of each other run comes first
    one, other, gap = one[order], other[order], gap[order]
    offset, way = places.px[other] - places.px[one], places.direction[one]
    across = way[:, 0] * offset[:, 1] - way[:, 1] * offset[:, 0]
    along = np.abs((way * offset).sum(axis=1))
    parallel = np.abs((way * places.direction[other]).sum(axis=1)) >= math.cos(ANGLE)
    step = 0.5 * (places.length_px[one] + places.length_px[other])
    bad = parallel & (along <= step) & (places.shown[one] > FULL) & (places.shown[other] > FULL)
    bad &= (places.to_end_px[one] > distance) & (places.to_end_px[other] > distance)
    bad &= _to_crossing(places, one, other, across) > distance
    found = np.full(len(places.px), np.inf)
    np.minimum.at(found, one[bad], np.abs(across[bad]))
    return np.where(found < distance, found, np.inf)


def _to_crossing(places, one, other, across):
    """Per pair of samples, sorted by the two runs, then the first sample: pixels along the first line to its nearest
    crossing with the second; inf if they do not cross. `across`: signed distance of the second sample."""
    run, beside = places.run[one], places.run[other]
    lead = np.ones(len(one), bool)  # the nearest of the pairs of one sample and one run
    lead[1:] = (one[1:] != one[:-1]) | (beside[1:] != beside[:-1])
    chain = np.ones(len(one), np.int64)  # number of the pair of runs
    chain[1:] = (run[1:] != run[:-1]) | (beside[1:] != beside[:-1])
    chain = np.cumsum(chain)
    reach = np.ptp(places.arc_px) + 1e4 if len(one) else 1.0
    axis = chain * reach + (places.arc_px[one] - places.arc_px.min() if len(one) else 0.0)
    first = np.flatnonzero(lead)
    here, there = first[:-1], first[1:]
    flips = (chain[here] == chain[there]) & (one[there] - one[here] <= 2)
    flips &= (across[here] * across[there] <= 0) & (np.abs(across[here] - across[there]) > CROSSES)
    crossings = np.concatenate([[-np.inf], (axis[here][flips] + axis[there][flips]) / 2, [np.inf]])
    after = np.searchsorted(crossings, axis)
    return np.minimum(axis - crossings[after - 1], crossings[np.minimum(after, len(crossings) - 1)] - axis)


def _pairs(px, distance):
    """(one, other, gap) of all ordered pairs of points closer than `distance`, by a grid with cells of that size."""
    cell = np.floor(px / distance).astype(np.int64)
    cell -= cell.min(axis=0) - 1 if len(cell) else 0
    columns = cell[:, 0].max() + 2 if len(cell) else 1
    number = cell[:, 1] * columns + cell[:, 0]
    order = np.argsort(number, kind="stable")
    sorted_ = number[order]
    found = []
    for step in [row * columns + column for row in (-1, 0, 1) for column in (-1, 0, 1)]:
        begin, end = (np.searchsorted(sorted_, number + step, side=side) for side in ("left", "right"))
        count = end - begin
        one = np.repeat(np.arange(len(px)), count)
        within = np.arange(len(one)) - np.repeat(np.cumsum(count) - count, count)
        other = order[np.repeat(begin, count) + within]
        gap = np.hypot(*(px[other] - px[one]).T)
        near = (gap < distance) & (one != other)
        found.append((one[near], other[near], gap[near]))
    return tuple(np.concatenate(parts) for parts in zip(*found))


def rows(scene, drawn, distance):
    """Result rows: shares of the fully drawn samples that are crowded; `distance`: spacing in reference pixels."""
    places = drawn.places()
    distance *= drawn.view.reference_scale
    nearest = nearest_alongside(places, distance)
    full = int((places.shown > FULL).sum())
    limits = {f"nearer than d = {distance:g} px": distance, "nearer than d by half a pixel": distance - 0.5}
    limits |= {"nearer than d / 2": distance / 2}
    told = {words: float((nearest < limit).sum() / max(full, 1)) for words, limit in limits.items()}
    shares = [(f"fully drawn samples {words}, share", share, "0") for words, share in told.items()]
    ends = float((places.to_end_px[places.shown > FULL] <= distance).mean()) if full else 0.0
    counted = [("samples drawn", len(places.shown)), ("samples fully drawn", full)]
    counted += [("fully drawn samples within d of an end, not looked at, share", ends)]
    faint = float((places.shown < 0.02).mean()) if len(places.shown) else 0.0
    return [
        {"figure": figure, "scene": scene, "value": value, "wanted": wanted}
        for figure, value, wanted in [*shares, *[(*c, None) for c in counted], ("samples left out, share", faint, None)]
    ]
