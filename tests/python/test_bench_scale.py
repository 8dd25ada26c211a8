# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea bench scale`: which scenes are asked for, and how growth is told."""

import json

import pytest
from bench import scale


def row(scene, count, first, **more):
    return {"scene": scene, "count": count, **dict.fromkeys(scale.COLUMNS[2:]), "first_s": first, **more}


def test_exponents_are_those_of_the_count_from_row_to_row_of_a_scene():
    rows = [row("grid", 100, 1.0), row("grid", 200, 4.0), row("grid", 400, 8.0), row("objects", 1000, 8.0)]
    assert scale.exponents(rows) == [{}, {"first_s": pytest.approx(2)}, {"first_s": pytest.approx(1)}, {}]
    assert "first 2.00" in scale.table(rows).splitlines()[2]


def test_what_was_not_measured_has_no_exponent_and_its_problem_is_told():
    rows = [row("grid", 100, 1.0), row("grid", 200, None, problem="stopped after 900 s")]
    assert scale.exponents(rows) == [{}, {}] and scale.exponents([]) == []
    assert scale.table(rows).splitlines()[-1] == "grid 200: stopped after 900 s"


def test_bounds_are_told_beside_the_counts_that_have_them():
    (name, count), bound = next(iter(scale.BOUNDS.items()))
    assert f"first_s {bound['first_s']}, peak_mb {bound['peak_mb']}" in scale.table([row(name, count, 1.0)])
    all_bounds = scale.BOUNDS.items()
    assert all(count in scale.COUNTS[name] and set(most) <= set(scale.COLUMNS) for (name, count), most in all_bounds)


def measured(monkeypatch, **found):
    """Instead of measuring, 10,000 and 100,000 objects took a second for each 10,000, and this."""
    monkeypatch.setattr(scale.peers, "measured", lambda _, asked, *__: ({"first_s": asked["count"] / 1e4, **found}, ""))
    monkeypatch.setattr(scale, "COUNTS", {"objects": (10_000, 100_000)})


@pytest.mark.parametrize("own, status", [(2000, 0), (3000, 0), (3001, 1)])
def test_of_objects_the_memory_beside_blenders_own_is_bound(monkeypatch, capsys, own, status):
    measured(monkeypatch, peak_mb=9000, blank_mb=9000 - own, own_mb=own)
    assert scale.main(["--json"], "blender", {}, None) == status
    told = "fovea: objects, 100,000: over its bound, own_mb 3001 of 3000\n"
    assert capsys.readouterr().err.endswith(told) == bool(status)


def test_a_scene_that_takes_longer_than_its_bound_is_named(monkeypatch, capsys):
    monkeypatch.setitem(scale.BOUNDS, ("objects", 100_000), {"first_s": 9})
    measured(monkeypatch)
    assert scale.main(["--json"], "blender", {}, None) == 1
    assert "objects, 100,000: over its bound, first_s 10.0 of 9\n" in capsys.readouterr().err


def test_exponents_are_in_the_json(monkeypatch, capsys):
    measured(monkeypatch, peak_mb=100)
    scale.main(["--json"], "blender", {}, None)
    rows = json.loads(capsys.readouterr().out)
    assert [row["exponents"] for row in rows] == [{}, {"first_s": 1.0, "peak_mb": 0.0}]
    assert all({"scene", "count", "first_s", "moved_s", "peak_mb"} <= set(row) for row in rows)


def test_scenes_have_all_their_counts_or_the_one_that_is_asked_for():
    assert scale.parse(["--scenes", "grid:500,objects"]).scenes == [
        ("grid", 500), *(("objects", count) for count in scale.COUNTS["objects"])
    ]  # fmt: skip
    quick = scale.parse(["--quick"]).scenes
    assert quick == [(name, count // scale.QUICK) for name, counts in scale.COUNTS.items() for count in counts]


@pytest.mark.parametrize("wrong", ["cubes", "grid:0", "grid:-1", "grid:x"])
def test_other_scenes_and_counts_are_refused(wrong, capsys):
    with pytest.raises(SystemExit):
        scale.parse(["--scenes", wrong])
    assert wrong.partition(":")[2 if ":" in wrong else 0] in capsys.readouterr().err
