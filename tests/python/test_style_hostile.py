# SPDX-License-Identifier: GPL-3.0-or-later
"""Malicious or nonsensical style files: one sentence that names the place, and no other effect."""

import copy
import json
import os
import random

import pytest

from addon import style
from addon.style import LARGEST, MOST_WORDS

FULL = {name: json.loads(style.dump(style.load(name))) for name in style.names()}
NASTY = [
    *(None, True, False, 0, -1, 1e300, 10**299, -(10**299), 0.5, "", "x", "../../etc/passwd", "/etc/passwd", "..\\x"),
    *("a/b", "a\0b", "\ud800", "x" * 100000, "C:\\x", "solid.png", "..", ".", [], [[]], [1, 2, 3, 4], [None] * 3),
    [[0, 0]] * 33,
    *({}, {"x": {}}, {"from": 1}, [{}], float("nan"), float("inf"), -float("inf"), [1e400] * 3, {"schema": 1}),
]
NEW_KEYS = ["new", "", "a.b", "[0]", "widht", "\n", "kept", "__class__"]
PATHS = ["../secret", "/etc/passwd", "a/b", "..", ".", "a\\b", "ink.png", "C:\\ink", "a\0b", "~", "$HOME", "%2e%2e", ""]


def refusal(text):
    """The sentence about a text that is refused."""
    with pytest.raises(style.StyleError) as error:
        style.parse(text)
    return checked(error.value)


def checked(error):
    sentence = str(error)
    assert sentence and sentence.isprintable() and len(sentence) < MOST_WORDS + 100
    sentence.encode()
    return sentence


def places(value, path=()):
    """Paths of all values that a style has, containers included."""
    if path:
        yield path
    steps = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for step, inner in steps:
        yield from places(inner, (*path, step))


def with_value(data, path, value):
    changed = copy.deepcopy(data)
    place = changed
    for step in path[:-1]:
        place = place[step]
    place[path[-1]] = value
    return changed


def at(data, path):
    for step in path:
        data = data[step]
    return data


def of_wrong_type(value):
    """Values of types that cannot stand where this one does."""
    if isinstance(value, bool):
        return ["true", 1, [], {}, None]
    if isinstance(value, str):
        return [1, True, [value], {value: 1}]
    if isinstance(value, (int, float)):
        return [str(value), [value], {"value": value}, 10**299]
    return ["text", 3, True] + ([{}] if isinstance(value, list) else [[]] if isinstance(value, dict) else [])


def shown(path):
    return "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in path)[1:]


@pytest.mark.parametrize("name", style.names())
def test_every_value_of_a_wrong_type_is_named(name):
    """One by one, every value of a full dump: the sentence names the value, or the list or object it is in. Of what is
    alike in a list, it is the value in the last item."""
    data, tried = FULL[name], 0
    # Any text may be a name; what may be null has its own tests.
    given = [path for path in places(data) if path[-1] != "name" and at(data, path) is not None]
    for path in {tuple("item" if isinstance(step, int) else step for step in path): path for path in given}.values():
        for wrong in of_wrong_type(at(data, path)):
            if path[-1] == "background" and wrong is None:
                continue
            sentence = refusal(json.dumps(with_value(data, path, wrong)))
            named = [shown(path[:i]) for i in range(max(len(path) - 2, 1), len(path) + 1)]
            assert any(sentence.startswith(place) for place in named), (path, wrong, sentence)
            tried += 1
    assert tried > 300, tried


def test_random_changes_are_read_or_refused_and_nothing_else():
    """Thousands of them, several at a time: what is read is written and read again, what is refused is told."""
    rng, outcomes = random.Random(20), {"read": 0, "refused": 0}
    for _ in range(3000):
        data = copy.deepcopy(FULL[rng.choice(list(FULL))])
        for _ in range(rng.randint(1, 3)):
            paths = list(places(data))
            path = rng.choice(paths)
            place = at(data, path[:-1])
            action = rng.random()
            if action < 0.6:
                place[path[-1]] = copy.deepcopy(rng.choice(NASTY))
            elif action < 0.8:
                del place[path[-1]]
            elif isinstance(place, dict):
                place[rng.choice(NEW_KEYS)] = copy.deepcopy(rng.choice(NASTY))
        try:
            read = style.parse(json.dumps(data))
        except style.StyleError as error:
            checked(error)
            outcomes["refused"] += 1
        else:
            written = style.dump(read)
            again = style.parse(written)
            assert again == read and style.dump(again) == written
            outcomes["read"] += 1
    assert min(outcomes.values()) > 300, outcomes
    assert {name: json.loads(style.dump(style.load(name))) for name in style.names()} == FULL, "nothing else changes"


# Names of what is in a scene, which never become those of files.
IN_SCENES = ("name", "object", "collection", "material", "attribute", "priority_attribute", "density_attribute")
IN_SCENES += tuple(f"paint_{member}_name" for member in ("width", "opacity", "color"))


@pytest.mark.parametrize("name", style.names())
def test_no_text_leads_out_of_its_folder(name):
    data = FULL[name]
    texts = [path for path in places(data) if isinstance(at(data, path), str) and path[-1] not in IN_SCENES]
    assert {path[-1] for path in texts} >= {"texture", "cap", "width_unit", "texture_anchor", "shading", "model"}
    for path in texts:
        for wrong in PATHS:
            assert refusal(json.dumps(with_value(data, path, wrong))).startswith(shown(path))


@pytest.mark.parametrize("opening", ["[", '{"a":', '{"schema": 1, "line_sets": [{"pen": ' + "[" * 50])
@pytest.mark.parametrize("depth", [40, 5000, 100000])
@pytest.mark.parametrize("closed", [False, True])
def test_deep_nesting(opening, depth, closed):
    closing = opening.replace('"line_sets": [', "").translate({ord("["): "]", ord("{"): "}"})
    text = opening * depth + "1" + "".join(c for c in reversed(closing) if c in "]}") * depth * closed
    assert "style" in refusal(text) or "nested" in refusal(text)


def test_nesting_is_named_where_it_begins():
    data = {"schema": 1, "line_sets": [{"pen": {"more": json.loads("[" * 40 + "]" * 40)}}]}
    assert refusal(json.dumps(data)).startswith("line_sets[0].pen.more[0][0]")


@pytest.mark.parametrize(
    "number",
    ["1e400", "-1e400", "NaN", "Infinity", "-Infinity", "1" + "0" * 5000, "-1" + "0" * 5000, "1" + "0" * 299],
)
@pytest.mark.parametrize("place", ['"width": {}', '"unknown": {}', '"unknown": [{{"x": {}}}]', '"color": [0, 0, {}]'])
def test_numbers_beyond_all_bounds(number, place):
    text = f'{{"schema": 1, "line_sets": [{{"pen": {{{place.format(number)}}}}}]}}'
    if number[-1] in "Ny":
        assert "not JSON at line 1" in refusal(text)
    elif len(number) == 300 and "unknown" in place:
        assert json.loads(style.dump(style.parse(text)))["line_sets"][0]["pen"]["unknown"], "a number like another"
    else:
        assert refusal(text).startswith("line_sets[0].pen.")


@pytest.mark.parametrize(
    "text, sentence",
    [
        ('{"schema": 1, "schema": 1, "line_sets": [{}]}', "the style gives 'schema' twice"),
        ('{"schema": 1, "line_sets": [{"pen": {"width": 1, "width": 2}}]}', "line_sets[0].pen gives 'width' twice"),
        ('{"schema": 1, "line_sets": [{}], "new": {"a": 1, "a": 1}}', "new gives 'a' twice"),
        ('{"schema": 1, "line_sets": [{"name": "\\ud800"}]}', "not JSON at line 1, column"),
        ('{"schema": 1, "line_sets": [{"\\udc00": 1}]}', "not JSON at line 1, column"),
        ("", "not JSON"),
        ("null", "the style must be a JSON object"),
        ("1e400", "the style is 1e400, not a finite number"),
        ('"text"', "the style must be a JSON object"),
        ('{"schema": 1, "line_sets": [{}]} {}', "not JSON at line 1, column 34"),
        ("{'schema': 1}", "not JSON"),
        ('{"schema": 1, "line_sets": [{},]}', "not JSON"),
    ],
)
def test_what_is_no_style(text, sentence):
    assert sentence in refusal(text)


def a_pipe(path):
    os.mkfifo(path)


on_unix = pytest.mark.skipif(os.name != "posix", reason="Windows has no such files")


def of_200_mb(path):
    path.touch()
    os.truncate(path, 200_000_000)


@pytest.mark.parametrize(
    "made, cause",
    [
        (lambda path: None, "No such file or directory"),
        (lambda path: path.mkdir(), "it is no file"),
        pytest.param(a_pipe, "it is no file", marks=on_unix),  # would keep waiting who reads it
        pytest.param(lambda path: path.symlink_to("/dev/zero"), "it is no file", marks=on_unix),
        pytest.param(lambda path: path.symlink_to(path), "Too many levels of symbolic links", marks=on_unix),
        (of_200_mb, "it has more than 1 MB"),
    ],
)
def test_what_is_no_style_file_is_refused_before_it_is_read(tmp_path, made, cause):
    made(tmp_path / "a.json")
    with pytest.raises(style.StyleError) as error:
        style.named(str(tmp_path / "a.json"))
    assert checked(error.value) == f"the style {tmp_path / 'a.json'} cannot be read: {cause}"


def test_a_name_with_a_zero_is_no_file(tmp_path):
    (tmp_path / "a").write_text(style.dump(style.load("plain")))
    with pytest.raises(style.StyleError, match="cannot be read"):
        style.read(str(tmp_path / "a\0b"))


@pytest.mark.parametrize(
    "place, data",
    [
        ("line_sets[0].pen.texture", {"line_sets": [{"pen": {"texture": "mine"}}]}),
        ("paper.texture", {"line_sets": [{}], "paper": {"texture": "mine"}}),
    ],
)
def test_pictures_beside_a_style_file_are_not_looked_for(tmp_path, place, data):
    """Textures and papers are those that ship, whatever a file's folder has."""
    (tmp_path / "a.json").write_text(json.dumps({"schema": 1, **data}))
    for folder in (tmp_path, tmp_path / "textures", tmp_path / "papers"):
        folder.mkdir(exist_ok=True)
        a_pipe(folder / "mine.png")
    with pytest.raises(style.StyleError) as error:
        style.named(str(tmp_path / "a.json"))
    assert checked(error.value).startswith(f"{place} is 'mine'; there are: ")


def test_fifty_thousand_keys_that_are_not_known_are_kept():
    data = {"schema": 1, "line_sets": [{"pen": {f"key_{i}": 0 for i in range(50000)}}]}
    read = style.parse(json.dumps(data))
    assert len(style.unknown(read)) == 50000 and len(style.remark(read)) < 1000
    assert style.parse(style.dump(read)) == read if len(style.dump(read)) < LARGEST else True
    twice = '{"schema": 1, ' + ",".join(f'"key_{i}": 0' for i in range(50000)) + ', "key_7": 1}'
    assert "gives 'key_7' twice" in refusal(twice)


def test_a_wrong_number_among_many_under_a_long_key_is_refused():
    data = {"schema": 1, "line_sets": [{}], "k" * 400000: [0] * 100000 + [1e400]}
    assert "not a finite number" in refusal(json.dumps(data).replace("Infinity", "1e400"))


def test_files(tmp_path):
    def refused(data):
        (tmp_path / "a.json").write_bytes(data)
        with pytest.raises(style.StyleError) as error:
            style.read(tmp_path / "a.json")
        return checked(error.value)

    good = style.dump(style.load(style.DEFAULT)).encode()
    (tmp_path / "good.json").write_bytes(b"\xef\xbb\xbf" + good)
    assert style.read(tmp_path / "good.json") == style.load(style.DEFAULT)
    assert refused(good[:40] + b"\xff\xfe" + good[40:]) == "the style is not text in UTF-8: byte 40 is not"
    large = f"the style {tmp_path / 'a.json'} cannot be read: it has more than 1 MB"
    assert refused(good + b" " * 50_000_000) == refused(b"[" * 50_000_000) == large
    assert "not JSON" in refused(b"\0" * 1000)
    with pytest.raises(style.StyleError, match="more than 1 MB"):
        style.parse(" " * (LARGEST + 1))
