# SPDX-License-Identifier: GPL-3.0-or-later
"""The agreement benchmark: which samples it considers near a change of visibility, and its counts."""

from types import SimpleNamespace

import numpy as np
import pytest
from bench import quality


def clipped():
    """Two pieces: one of two segments (8 and 4 px, samples of 2 px), one of a segment of 6 px; padding between."""
    return SimpleNamespace(
        offsets=np.array([0, 3, 5], np.uint32),
        sample_count=np.array([4, 2, 0, 3, 0], np.uint32),
        sample_start=np.array([2, 6, 8, 11, 14], np.uint32),
        arc_px=np.array([-6.0, 2.0, 6.0, 0.0, 6.0]),
    )


def runs(piece, start, end):
    return SimpleNamespace(piece=np.array(piece, np.uint32), start_px=np.array(start), end_px=np.array(end))


def test_samples_know_where_they_are():
    samples = quality.Samples(clipped())
    assert samples.index.tolist() == [2, 3, 4, 5, 6, 7, 11, 12, 13]
    assert samples.piece.tolist() == [0] * 6 + [1] * 3
    assert samples.arc_px.tolist() == [-5, -3, -1, 1, 3, 5, 1, 3, 5]


def test_distance_is_to_changes_of_the_same_piece():
    samples = quality.Samples(clipped())
    distance = samples.distance_to_ends(runs([0, 0, 1], [-6.0, 2.0, 0.0], [-1.5, 6.0, 6.0]))
    assert distance[:6] == pytest.approx([3.5, 1.5, 0.5, 1.0, 1.0, 3.0])
    assert (distance[6:] > 100).all()


def test_shares_by_how_far_changes_are():
    exact = np.zeros(16, np.float32)
    exact[[2, 3, 4]] = 1, 1, 0.25
    visible = runs([0], [-6.0], [-1.5])
    visible.samples = lambda _: exact
    beside = (exact >= 0.5).astype(np.uint8) * (np.arange(16) != 2)
    truth = quality.Truth(SimpleNamespace(clipped=clipped(), visible=visible, seen_beside=lambda _: beside))
    assert truth.far["path"].tolist() == [True, False, False, True, True, True, True, True, True]
    assert truth.far["image"].tolist() == [False, False, False, True, True, True, True, True, True]
    looked = exact.copy()
    looked[[2, 3, 12]] = 0.5, 0.8, 1
    found = truth.compare(looked)
    assert found["samples"] == 9
    assert found["all"]["falsely_hidden"] == pytest.approx(1 / 9)
    assert found["path"]["falsely_visible"] == pytest.approx(1 / 7)
    assert found["image"]["falsely_hidden"] == 0
    assert found["image"]["agree"] == pytest.approx(5 / 6)
