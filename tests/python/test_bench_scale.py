# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea bench scale`: which scenes are asked for, and how growth is told."""

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
    (name, count), (seconds, megabytes) = next(iter(scale.BOUNDS.items()))
    assert f"{seconds} s, {megabytes} MB" in scale.table([row(name, count, 1.0)])
    assert all(count in scale.COUNTS[name] for name, count in scale.BOUNDS)


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
