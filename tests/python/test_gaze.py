# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the eye goes, on pictures whose odd one is known: observers that look where salience is, heat maps, and the
search for an emphasis."""

from dataclasses import dataclass

import numpy as np
import pytest
from command import gaze as command
from native_core import core

from addon import gaze

SIZE = 320, 240
TILES = [((i % 4 + 0.5) * SIZE[0] / 4, (i // 4 + 0.5) * SIZE[1] / 3) for i in range(12)]
GREEN, PALE, RED, WHITE = (40, 160, 40), (215, 235, 215), (200, 40, 40), (255, 255, 255)


def away_from(place):
    rows, columns = np.mgrid[: SIZE[1], : SIZE[0]] + 0.5
    return np.hypot(columns - place[0], rows - place[1])


def discs(odd, color=RED, others=GREEN):
    """(H, W, 3) of twelve discs of one color, but for one."""
    picture = np.full((SIZE[1], SIZE[0], 3), WHITE, np.uint8)
    for i, place in enumerate(TILES):
        picture[away_from(place) < 14] = color if i == odd else others
    return picture


def focus_at(number):
    """(H, W): 0 at a disc, 1 from 60 pixels away on."""
    return np.clip((away_from(TILES[number]) - 20) / 40, 0, 1)


def test_the_first_place_is_the_odd_disc():
    for odd in (0, 6, 11):
        seen = gaze.look(discs(odd))
        assert np.hypot(*(seen.places[0] - TILES[odd])) < 20
        assert seen.saliences[0] == 1 and (np.diff(seen.saliences) <= 0).all()


def test_a_second_model_agrees_where_there_is_one_disc_alone():
    picture = np.full((SIZE[1], SIZE[0], 3), WHITE, np.uint8)
    picture[away_from(TILES[6]) < 14] = RED
    assert gaze.look(picture).agreed
    assert "second model" not in gaze.sentence(gaze.look(picture))


def test_focus_wins_where_all_else_is_pale_and_not_elsewhere():
    evenly = gaze.look(discs(None))
    seen = gaze.look(discs(6, GREEN, others=PALE))
    there, elsewhere = (gaze.judge(seen, evenly, focus_at(i)) for i in (6, 0))
    assert there.wins and there.gain > gaze.WANTED_GAIN and there.ratio > 1.2 and there.first_in_focus
    assert not elsewhere.wins and elsewhere.gain < 1 and not elsewhere.first_in_focus
    assert gaze.judge(evenly, evenly, focus_at(6)).gain == 1


def test_observers_whose_gaze_is_spread_like_salience_have_the_share_that_is_told():
    """The time average of emphasis under fixations, E_f of Cole 2009, 5.3.3, of simulated observers."""
    seen, focus = gaze.look(discs(6)), focus_at(6)
    map_, random = seen.salience.map.astype(float), np.random.default_rng(1)
    cells = random.choice(map_.size, 4000, p=map_.ravel() / map_.sum())
    rows, columns = np.unravel_index(cells, map_.shape)
    at = tuple(((index + 0.5) / count * size).astype(int) for index, count, size in
               zip((rows, columns), map_.shape, focus.shape))  # fmt: skip
    share = gaze.judge(seen, seen, focus).share
    assert (1 - focus)[at].mean() == pytest.approx(share, abs=0.03)


def test_an_even_picture_has_no_place_and_that_is_said():
    seen = gaze.look(np.full((SIZE[1], SIZE[0], 3), 200, np.uint8))
    assert len(seen.places) == 0 and not seen.agreed
    assert "Nothing" in gaze.sentence(seen) and gaze.told(seen)["fixations"] == []
    assert not gaze.judge(seen, seen, focus_at(0)).wins
    assert gaze.heat(seen).shape == (SIZE[1], SIZE[0], 3)


def test_places_are_told_as_focus_takes_them_with_the_names_of_objects():
    seen = gaze.look(discs(8))  # in the upper row, at the left
    found = gaze.told(seen, ["Cup"], gaze.judge(seen, seen, focus_at(8)))
    first = found["fixations"][0]
    assert (first["x"], first["y"]) == pytest.approx((1 / 8, 1 / 6), abs=0.06) and first["object"] == "Cup"
    assert found["focus"]["first"] and found["focus"]["gain"] == 1 and not found["focus"]["wins"]
    assert gaze.sentence(seen, ["Cup"]).startswith("The eye goes to 'Cup' first")


def test_heat_is_warm_at_the_first_place_and_gray_where_nothing_stands_out():
    seen = gaze.look(discs(6))
    heat = gaze.heat(seen).astype(int)
    warm = heat[..., 0] - heat[..., 2]
    assert warm[away_from(TILES[6]) < 5].min() > 60
    salience = seen.salience.of_pixels(*SIZE)
    assert salience.max() == 1 and salience.shape == (SIZE[1], SIZE[0])


@dataclass(frozen=True)
class Drawn:
    judged: gaze.Judged


def judged(wins):
    return Drawn(gaze.Judged(0.5, 0.25 if wins else 0.5, 1.0, first_in_focus=wins))


def test_the_emphasis_found_is_little_above_the_least_that_wins():
    tried = []

    def drawn(emphasis):
        tried.append(emphasis)
        return judged(emphasis >= 2.5)

    emphasis, found = gaze.strengthened(drawn, 1.0, 10.0)
    assert 2.5 <= emphasis <= 2.5 * 1.08 and found.judged.wins
    assert len(tried) == 1 + gaze.HALVINGS
    emphasis, found = gaze.strengthened(lambda _: judged(False), 1.0, 10.0)
    assert emphasis == 10.0 and not found.judged.wins


def test_the_command_looks_at_png_files(tmp_path):
    path = tmp_path / "a.png"
    path.write_bytes(core.png_bytes(discs(6)))
    options, rest = command.parse([str(path), "--json", "-o", str(tmp_path / "heat.png")])
    assert options.json and rest == []
    assert core.pixels_of_png(path.read_bytes()).tolist() == discs(6).tolist()
    seen = gaze.look(core.pixels_of_png(path.read_bytes()))
    gaze.write(seen, tmp_path / "heat.png")
    assert (core.pixels_of_png((tmp_path / "heat.png").read_bytes()) == gaze.heat(seen)).all()
    with pytest.raises(ValueError, match="PNG"):
        core.pixels_of_png(b"no")


@pytest.mark.parametrize(
    "words, told",
    [
        (["{}/a.png", "--style", "pencil"], "taken as it is"),
        (["{}/b.png"], "there is no file"),
        (["office", "-o", "heat.jpg"], "a heat map is a .png"),
        (["offices"], "offices"),
        (["office", "--frames", "1-3"], "--frames"),
    ],
)
def test_the_command_refuses_what_it_cannot_do(words, told, tmp_path, capsys):
    (tmp_path / "a.png").write_bytes(core.png_bytes(discs(6)))
    with pytest.raises((SystemExit, ValueError)) as refused:
        command.parse([word.format(tmp_path) for word in words])
    assert told in capsys.readouterr().err + str(refused.value)
