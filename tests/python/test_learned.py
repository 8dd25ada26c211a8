# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines learned from drawings by local properties of pixels: synthetic artists are recovered, and other scenes drawn as
they would."""

import json

import numpy as np
import pytest
from command import learn
from native_core import Mesh, core, scene, sphere, view

from addon import learned_lines

SIZE = 320, 240
NAMES = [name for name, _ in core.LocalProperties.names]


def waves(phase, n=96):
    """A relief of two waves over [-1, 1]^2."""
    y, x = np.meshgrid(np.linspace(-1, 1, n + 1), np.linspace(-1, 1, n + 1), indexing="ij")
    z = 0.12 * np.sin(5 * x + 2 * y + phase) + 0.08 * np.sin(7 * y - 3 * x + 2 * phase)
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    faces = np.stack([a, a + 1, a + n + 2, a + n + 1], axis=1)
    return Mesh("waves", np.stack([x, y, z], -1).reshape(-1, 3), faces.tolist())


def properties(phase=0.3, size=SIZE):
    return core.LocalProperties(scene([waves(phase).surface()]), view((0.4, -1.5, 3), (0, 0, 0), size=size))


def of(found, name):
    """(H, W) of a property."""
    return found.values[..., NAMES.index(name)]


def artist(found, name="view_curvature", quantile=0.85):
    """The Bitmap of an artist who draws crests of a property, where it is high."""
    values = np.where(found.known > 0, of(found, name), 0)
    least = np.quantile(values[found.known > 0], quantile)
    return core.lines_of(core.crests_of(np.clip(values / least / 2, 0, 1)), 0.5)


@pytest.fixture(scope="module")
def seen():
    return properties()


def test_properties_are_those_of_a_sphere():
    found = core.LocalProperties(scene([sphere(48).surface()]), view((0, -4, 0), (0, 0, 0), size=SIZE))
    assert found.values.shape == (*SIZE[::-1], len(NAMES)) and np.isfinite(found.values).all()
    middle = SIZE[1] // 2, SIZE[0] // 2
    assert of(found, "facing")[middle] == pytest.approx(1.0, abs=1e-3)
    assert of(found, "gaussian_curvature")[middle] == pytest.approx(of(found, "mean_curvature")[middle] ** 2, rel=0.02)
    assert found.known[0, 0] == 0 and not found.values[0, 0].any()
    with pytest.raises(ValueError, match="read-only"):
        found.values[0, 0, 0] = 1


@pytest.mark.parametrize("kind", learn.KINDS)
def test_an_artist_who_draws_crests_of_a_property_is_recovered(seen, kind):
    found = learned_lines.learn(seen, [artist(seen)], kind)
    assert found.found["auc"] > 0.93 and found.found["r2"] > 0.4
    assert found.found["f1"] > 0.7, found.found


def test_the_property_that_an_artist_goes_by_is_the_most_important_one(seen):
    """Of areas, which know no direction."""
    for name in ("second_curvature", "radial_torsion", "image_gradient"):
        drawn = core.Bitmap(((of(seen, name) > np.quantile(of(seen, name), 0.8)) & (seen.known > 0)).astype(np.uint8))
        found = learned_lines.learn(seen, [drawn], "tree", tolerance=1.0).found
        assert next(iter(found["importance"])) == name


def test_what_is_learned_of_a_scene_draws_another_one_as_the_artist_would(seen):
    """Better than a drawing of the scene that was learned from would be."""
    model = learned_lines.learn(seen, [artist(seen)], "forest").model
    other = properties(phase=2.0, size=(480, 360))
    probability, lines = learned_lines.drawn(model, other)
    assert probability.shape == (360, 480) and 0 <= probability.min() and probability.max() <= 1
    judge = artist(other)
    near = lines.measures(judge, judge.usual_tolerance)["f1"]
    assert near > 0.7 and near > 0.2 + artist(properties(size=(480, 360))).measures(judge, judge.usual_tolerance)["f1"]
    fewer = learned_lines.drawn(model, other, threshold=0.95)[1]
    assert fewer.pixels.sum() < lines.pixels.sum()


def test_a_model_is_the_same_each_time_and_restored_from_its_file(seen):
    first, second = (learned_lines.learn(seen, [artist(seen)], "forest") for _ in range(2))
    assert first.model == second.model and first.found == second.found
    text = first.model.json()
    again = core.LineModel.of_json(text)
    assert again == first.model and again.json() == text
    assert again.threshold == first.found["threshold"] and again.kind == "forest"
    assert (again.probabilities(seen) == first.model.probabilities(seen)).all()
    assert again != again.with_threshold(0.123)
    json.dumps(first.found, allow_nan=False)


def test_what_is_important_is_told_away_from_outlines(seen):
    """An artist who draws crests of one property in the left half, and beside the outlines of the right one another."""
    right = np.arange(SIZE[0])[None, :] >= SIZE[0] // 2
    areas = [
        (of(seen, name) > np.quantile(of(seen, name), 0.8)) & (seen.known > 0)
        for name in ("luminance", "radial_torsion")
    ]
    drawn = core.Bitmap(np.where(right, *areas).astype(np.uint8))
    outlines = core.Bitmap(np.broadcast_to(right, drawn.pixels.shape).astype(np.uint8))
    found = learned_lines.learn(seen, [drawn], "tree", 1.0, outlines).found
    assert next(iter(found["importance"])) == "radial_torsion"
    everywhere = core.Bitmap(np.ones_like(drawn.pixels))
    assert learned_lines.learn(seen, [drawn], "tree", 1.0, everywhere).found["importance"] == {}


def test_files_that_are_no_models_are_told_by_name(tmp_path, seen):
    model, file = learned_lines.learn(seen, [artist(seen)]).model, tmp_path / "a.json"
    file.write_text(model.json(), encoding="utf-8")
    assert learned_lines.read(file) == model
    told = (
        r"a\.json: a model of lines: .*write it anew by `fovea learn`",
        r"a\.json cannot be read: it has more than 1 MB",
    )
    for content, said in zip((b"\xff\xfe\x00", b"{}", b"[" * 100, b" " * (3 << 20)), (*[told[0]] * 3, told[1])):
        file.write_bytes(content)
        with pytest.raises(ValueError, match=said):
            learned_lines.read(file)


def test_several_drawings_are_learned_as_their_mean(seen):
    one, other = artist(seen), core.Bitmap(np.zeros(SIZE[::-1], np.uint8))
    wanted = learned_lines.likelihood([one, other], 2.0)
    assert wanted == pytest.approx(learned_lines.likelihood([one], 2.0) / 2)
    assert wanted[one.pixels > 0] == pytest.approx(0.5)
    assert len(learned_lines.learn(seen, [one, one]).found["importance"]) == len(NAMES)


def test_pixels_held_out_are_a_quarter_in_blocks_and_not_learned_from(seen):
    held = learned_lines.held_out(*SIZE[::-1])
    assert held.mean() == pytest.approx(0.25, abs=0.02)
    changes = (held[:, 1:] != held[:, :-1]).mean()
    assert changes < 0.1, "blocks are many pixels wide"
    drawn, inside = artist(seen).pixels, core.Bitmap((~held).astype(np.uint8)).distances() > 3
    assert drawn[inside].any()
    drawings = core.Bitmap(drawn), core.Bitmap(np.where(inside, 0, drawn).astype(np.uint8))
    one, other = (learned_lines.learn(seen, [each], "tree", 0.1).model.probabilities(seen) for each in drawings)
    assert one == pytest.approx(other, abs=1e-6)


def test_areas_under_curves_are_shares_of_pairs():
    lines = np.array([True, True, False, False])
    assert learned_lines.auc(np.array([3, 2, 1, 0]), lines) == 1.0
    assert learned_lines.auc(np.array([0, 1, 2, 3]), lines) == 0.0
    assert learned_lines.auc(np.array([1, 1, 1, 1]), lines) == 0.5
    assert learned_lines.auc(np.array([2, 0, 1, 0]), lines) == 0.625
    assert learned_lines.auc(np.array([2, 0, 1, 0]), np.ones(4, bool)) is None


def test_what_cannot_be_learned_is_told_in_a_sentence(seen):
    with pytest.raises(ValueError, match="same everywhere.*nothing to learn from them"):
        learned_lines.learn(seen, [core.Bitmap(np.zeros(SIZE[::-1], np.uint8))])
    with pytest.raises(ValueError, match=r"a drawing has 4 x 3 pixels, and the frame 320 x 240: all have to be"):
        learned_lines.learn(seen, [core.Bitmap(np.ones((3, 4), np.uint8))])
    with pytest.raises(ValueError, match="a model of lines: it is not JSON"):
        core.LineModel.of_json("{")
    with pytest.raises(ValueError, match="expected shape"):
        core.LineModel("tree", np.zeros((3, 2), np.float32), np.zeros(3), np.ones(3))


def test_words_and_figures_of_the_command(tmp_path, capsys):
    drawing, model = tmp_path / "a.png", tmp_path / "a.json"
    for path in (drawing, model):
        path.write_bytes(b"")
    words = ["office", str(drawing), "-o", str(model)]
    assert learn.parse(words).kind == "tree" and learn.parse([*words, "--kind", "forest"]).kind == "forest"
    assert len(learn.parse(["office", str(drawing), str(drawing), *words[2:]]).drawings) == 2
    picture = ["--predict", "office", "--model", str(model), "-o", str(drawing)]
    assert learn.parse([*picture, "--size", "40x30"]).size == (40, 30)
    for wrong, told in (
        ([*words[:3], "a.png"], "a model is a .json"),
        (["office", *words[2:]], "name a drawing of the scene"),
        ([*words, "--kind", "bush"], "invalid choice"),
        ([*words, "--size", "40x30"], "--size does not go with learning from drawings"),
        ([*picture, "--kind", "tree"], "--kind does not go with --predict"),
        ([*picture[:4], "-o", "a.json"], "a picture is a .png"),
        ([*picture[:2], *picture[4:]], "--predict takes one scene, and --model"),
        ([*picture, "--threshold", "2"], "from 0 to 1"),
        (["office", "b.png", *words[2:]], "there is no file b.png"),
    ):
        with pytest.raises(SystemExit):
            learn.parse(wrong)
        assert told in capsys.readouterr().err
    found = {"pixels": 9, "r2": None, "auc": 0.75, "threshold": 0.5, "precision": 1.0, "recall": 0.5, "f1": 2 / 3}
    told = learn.told(found | {"tolerance_px": 2.0, "importance": {"facing": 0.25}, "model": "a.json"})
    assert told.splitlines()[0] == "of 9 pixels held out: R2 unknown, AUC 0.750"
    assert [line.split()[-1] for line in told.splitlines()[2:]] == ["importance:", "0.250", "a.json"]


def test_the_kinds_of_models_are_those_of_the_core():
    assert tuple(name for name, *_ in core.LineModel.kinds) == learn.KINDS
