# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties of every line definition in the registry, without naming any: `fovea lines` and `fovea draw` accept it."""

import numpy as np
import pytest
from command import draw_options, lines

from addon import catalogue, native, style

DEFINITIONS = {definition["name"]: definition for definition in catalogue.definitions()}
PARAMETERS = [(name, parameter) for name, d in DEFINITIONS.items() for parameter in d["parameters"]]
ABSENT = {"edge_mark", "intersection", "section_cut", "section_hatch", "learned_line"}  # what an OBJ file cannot have


def of_parameter(value):
    return value if isinstance(value, str) else value["name"]


def landscape(count=48):
    """OBJ text of an open surface of hills and hollows with a step across it, of two materials."""
    x, y = np.meshgrid(np.linspace(-2, 2, count), np.linspace(-2, 2, count), indexing="ij")
    z = 0.5 * np.exp(-2 * (x**2 + y**2)) + 0.12 * np.sin(3 * x + 1) * np.cos(2.5 * y) + 0.4 * (x > 1.2)
    rows = [f"v {p[0]:.6f} {p[1]:.6f} {p[2]:.6f}" for p in np.stack([x, y, z], -1).reshape(-1, 3)]
    for i in range(count - 1):
        rows += ["usemtl " + ("grass" if i < count // 3 else "rock")]
        corner = i * count + np.arange(1, count)
        rows += [f"f {c} {c + count} {c + count + 1} {c + 1}" for c in corner]
    return "\n".join(rows)


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    path = tmp_path_factory.mktemp("model") / "landscape.obj"
    path.write_text(landscape())
    return path


@pytest.fixture
def extract(model, tmp_path):
    def run(*words):
        options = lines.parse(
            [str(model), "-o", str(tmp_path / "out.npz"), "--eye", "3,-5,4", "--sun", "-2,1,0.8", *words]
        )
        return lines.extract(native.load(), options)[0]

    return run


@pytest.mark.parametrize("name", DEFINITIONS)
def test_lines_extracts_every_definition(extract, name):
    found = extract("--definition", name)
    assert str(found["definition"]) == name
    assert len(found["closed"]) > 0 or name in ABSENT
    # Lines of the image may run beside what is seen, by the width of what smooths it.
    in_image = DEFINITIONS[name]["scope"] == "scene"
    bounds = np.array((2.001, 2.001, 1.1)) * (1.05 if in_image else 1)
    assert np.isfinite(found["points"]).all() and (np.abs(found["points"]) <= bounds).all()
    assert ((found["strength"] >= 0) & (found["strength"] <= 1)).all()
    assert (np.diff(found["offsets"]) >= 2).all() and found["offsets"][-1] == len(found["points"])


@pytest.mark.parametrize("name, parameter", PARAMETERS, ids=of_parameter)
def test_every_parameter_takes_its_default_and_its_limits(extract, name, parameter):
    plain = extract("--definition", name)
    given = extract("--definition", name, "--param", f"{parameter['name']}={parameter['default']}")
    assert (given["points"] == plain["points"]).all()
    for end in ("min", "max"):
        found = extract("--definition", name, "--param", f"{parameter['name']}={parameter[end]}")
        assert np.isfinite(found["points"]).all()


@pytest.mark.parametrize("name, parameter", PARAMETERS, ids=of_parameter)
def test_a_value_out_of_range_is_refused_with_the_range(extract, name, parameter):
    with pytest.raises(ValueError, match=rf"definition\.{name}\.{parameter['name']} is .*, outside .* to "):
        extract("--definition", name, "--param", f"{parameter['name']}={parameter['max'] + 1}")


@pytest.mark.parametrize("name", DEFINITIONS)
def test_an_unknown_parameter_is_refused_with_the_known_ones(extract, name):
    file = DEFINITIONS[name]["file"]
    declared = [*DEFINITIONS[name]["parameters"], *([file] if file else [])]
    known = ", ".join(sorted(p["name"] for p in declared)) or "none"
    with pytest.raises(ValueError, match=f"unknown keys: shininess; known are: {known}"):
        extract("--definition", name, "--param", "shininess=1")


@pytest.mark.parametrize("word", ["angle", "angle=", "angle=wide", "angle=1,5"])
def test_a_parameter_without_a_number_is_refused(capsys, model, word):
    with pytest.raises(SystemExit):
        lines.parse([str(model), "--definition", "crease", "--eye", "1,1,1", "-o", "x.npz", "--param", word])
    assert f"'{word}' is not NAME=NUMBER" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        draw_options.parse(["--param", word])


@pytest.mark.parametrize("name", DEFINITIONS)
def test_draw_takes_every_definition(name):
    assert catalogue.named(draw_options.parse(["--lines", name]).lines) == [name]


def test_all_are_the_whole_registry_in_its_order():
    assert catalogue.named(draw_options.parse(["--lines", "all"]).lines) == list(DEFINITIONS)
    assert catalogue.named(draw_options.parse(["--sheet"]).lines) == list(DEFINITIONS)


def test_a_misspelt_definition_is_refused_with_all_names():
    with pytest.raises(ValueError, match="there is no line definition 'ridgy'") as error:
        catalogue.named(["crease", "ridgy"])
    assert all(name in str(error.value) for name in DEFINITIONS)


def test_a_style_may_name_every_definition_with_every_parameter():
    kinds = {name: {p["name"]: p["default"] for p in d["parameters"]} for name, d in DEFINITIONS.items()}
    for name, definition in DEFINITIONS.items():
        if file := definition["file"]:
            kinds[name][file["name"]] = f"models/artist{file['suffix']}"
    everything = style.Style(line_sets=(style.LineSet(kinds=kinds),))
    assert style.parse(style.dump(everything)) == everything


@pytest.mark.parametrize("name", DEFINITIONS)
def test_what_stands_for_a_slow_definition_in_drafts_is_a_quick_one_with_parameters_that_it_has(name):
    stand_ins = DEFINITIONS[name]["stand_ins"]
    assert not stand_ins or DEFINITIONS[name]["slow"]
    for other, values in stand_ins.items():
        assert not DEFINITIONS[other]["slow"]
        assert set(values) <= {parameter["name"] for parameter in DEFINITIONS[other]["parameters"]}


@pytest.mark.parametrize("name", DEFINITIONS)
def test_every_definition_says_what_it_is(name):
    definition = DEFINITIONS[name]
    assert name.isidentifier() and name == name.lower()
    texts = [definition["label"], definition["source"], definition["description"]]
    texts += [p[key] for p in definition["parameters"] for key in ("label", "meaning")]
    texts += [definition["file"][key] for key in ("label", "meaning")] if definition["file"] else []
    assert all(text.strip() == text and text[:1].isupper() for text in texts), texts
    assert all(p["min"] <= p["default"] <= p["max"] for p in definition["parameters"])
