# SPDX-License-Identifier: GPL-3.0-or-later
"""The documentation agrees with the program: every line definition, every key of a style, every link and picture."""

import json
import re
from pathlib import Path

import pytest
import scenes
from command import draw_options, figures, pages

from addon import catalogue, style

PROJECT = Path(__file__).parents[2]
DOCS = PROJECT / "addon" / "docs"
README = PROJECT / "README.md"
CONTRIBUTING = PROJECT / ".github" / "CONTRIBUTING.md"
# Of those who have the whole project.
DEVELOPERS = [README, CONTRIBUTING, figures.FOLDER / "README.md"]
TEXTS = [*sorted(DOCS.parent.rglob("*.md")), *DEVELOPERS]
DEFINITIONS = {definition["name"]: definition for definition in catalogue.definitions()}
PARAMETERS = [(name, parameter) for name, d in DEFINITIONS.items() for parameter in d["parameters"]]
UNITS = {"": "number", "bool": "switch"}  # what is not here is called as the registry calls it


def page(name):
    return (DOCS / "lines" / f"{name}.md").read_text(encoding="utf-8")


def rows(text):
    """Cells of the rows of all tables of a text."""
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if line.startswith("|")]


def row(text, key):
    """The cells of the row that tells of a key."""
    return next(cells for cells in rows(text) if cells[0] == f"`{key}`")


def shown(number, unit):
    return ("on" if number else "off") if unit == "bool" else f"{number:g}"


def anchors(path):
    """What links may lead to in a text: its headings as GitHub names them."""
    headings = re.findall(r"^#+ (.*)$", path.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("name", DEFINITIONS)
def test_a_definition_has_a_page_with_its_label_source_and_picture(name):
    text = page(name)
    assert text.startswith(f"# {DEFINITIONS[name]['label']}\n\n`{name}`\n")
    assert f"\n{DEFINITIONS[name]['source']}.\n" in text and f"]({name}.png)" in text
    headings = re.findall(r"^## (.*)$", text, re.MULTILINE)
    assert headings == ["When to take it, and when not", "Parameters", "How it is found", "Source", "Related"]


@pytest.mark.parametrize("name", DEFINITIONS)
def test_a_page_has_the_parameters_of_the_registry_and_no_other(name):
    told = [cells[0].strip("`") for cells in rows(page(name)) if cells[0].startswith("`")]
    assert told == [parameter["name"] for parameter in DEFINITIONS[name]["parameters"]]


@pytest.mark.parametrize("name, parameter", PARAMETERS, ids=lambda v: v if isinstance(v, str) else v["name"])
def test_a_parameter_has_its_unit_default_and_range(name, parameter):
    _, meaning, unit, default, limits = row(page(name), parameter["name"])
    low, value, high = (shown(parameter[key], parameter["unit"]) for key in ("min", "default", "max"))
    assert unit == UNITS.get(parameter["unit"], parameter["unit"]) and default == value and len(meaning) > 15
    assert limits == ("on or off" if parameter["unit"] == "bool" else f"{low} to {high}")


def test_the_contents_are_the_registry_in_its_order():
    found = re.findall(r"\[<img src=\"(\w+)\.png\"[^\]]*\]\((\w+)\.md\)", page("README"))
    assert found == [(name, name) for name in DEFINITIONS]
    assert {path.stem for path in (DOCS / "lines").glob("*.md")} == {*DEFINITIONS, "README"}


def test_every_picture_is_drawn_by_a_script_and_there_is_no_other():
    drawn = {DOCS / pages.file_of(name) for name in pages.names()}
    drawn |= {DOCS / figures.STEPS / f"{name}.jpg" for name in pages.STEPS}
    assert {path for path in DOCS.rglob("*") if path.suffix in (".png", ".jpg")} == drawn
    assert list(pages.LINES) == list(DEFINITIONS)


@pytest.mark.parametrize("name", pages.names())
def test_a_picture_is_small(name):
    content = (DOCS / pages.file_of(name)).read_bytes()
    is_png = pages.file_of(name).endswith(".png")
    assert content.startswith(b"\x89PNG\r\n\x1a\n" if is_png else b"\xff\xd8\xff")
    assert len(content) <= (40_000 if is_png else 90_000)


@pytest.mark.parametrize("name", pages.LINES)
def test_a_line_is_shown_by_words_that_draw_understands(name):
    shown = pages.LINES[name]
    options = draw_options.parse([*shown.camera, *shown.beneath_params])
    assert options.azimuth is not None and set(shown.beneath) <= set(DEFINITIONS)
    if shown.model.startswith(pages.LESSON):
        lessons = (PROJECT / "blender_scripts" / "scenes" / "lessons.py").read_text(encoding="utf-8")
        assert f'"{shown.model.removeprefix(pages.LESSON)}": ' in lessons
    elif not shown.model.endswith(".obj"):
        scenes.parse(shown.model)


@pytest.mark.parametrize("name", [*pages.WAY, *pages.FOCUS])
def test_a_stage_is_shown_by_words_that_draw_understands(name):
    shown = (pages.WAY | pages.FOCUS)[name]
    options = draw_options.parse(list(shown.words))
    assert options.style in style.names() and set(options.lines or ()) <= set(DEFINITIONS)


def test_a_picture_that_is_not_there_is_refused(capsys):
    with pytest.raises(SystemExit):
        figures.figures(None, ["lines/ridgy"])
    assert "there is no figure lines/ridgy" in capsys.readouterr().err


@pytest.mark.parametrize("path", TEXTS, ids=lambda path: str(path.relative_to(PROJECT)))
def test_links_and_pictures_exist(path):
    text = re.sub(r"```.*?```", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
    links = re.findall(r"\]\(([^)\s]+)\)", text) + re.findall(r"src=\"([^\"]+)\"", text)
    for link in links:
        file, _, anchor = link.partition("#")
        target = (path.parent / file).resolve() if file else path
        assert target.is_file(), link
        assert not anchor or anchor in anchors(target), link
        # The documentation is read where the add-on is installed, too: it leads nowhere else.
        assert path in DEVELOPERS or DOCS in (target, *target.parents), link


def test_readme_leads_to_every_page_of_the_documentation():
    linked = set(re.findall(r"\]\(addon/docs/([^)]+)\)", README.read_text(encoding="utf-8")))
    assert linked >= {path.name for path in DOCS.glob("*.md")} - {"README.md"} | {"lines/README.md"}


@pytest.mark.parametrize("text", ["addon/docs/command_line.md", "blender_scripts/command/help.txt"])
def test_every_option_of_draw_is_told(text, capsys):
    with pytest.raises(SystemExit):
        draw_options.parse(["--help"])
    options = set(re.findall(r"--[a-z-]+", capsys.readouterr().out)) - {"--help", "--output"}
    assert len(options) > 20
    told = (PROJECT / text).read_text(encoding="utf-8")
    assert [option for option in sorted(options) if not re.search(rf"{option}\b", told)] == []


def test_contributing_names_the_presets_there_are_and_packages_that_suites_have():
    text = CONTRIBUTING.read_text(encoding="utf-8")
    listed = json.loads((PROJECT / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]
    presets = {preset["name"] for preset in listed if not preset.get("hidden")}
    assert set(re.findall(r"--preset ([\w-]+)", text)) <= presets <= set(re.findall(r"`([\w-]+)`", text)) | {"release"}
    packages = re.search(r"apt-get install (g\+\+[^`]*?)\n\n", text)[1].replace("\\\n", "").split()
    suites = (PROJECT / "blender_scripts" / "command" / "packages.txt").read_text(encoding="utf-8").splitlines()
    assert set(packages) <= set(suites) and {"libcli11-dev", "nlohmann-json3-dev"} <= set(packages)


def test_every_text_is_found_from_the_first_page():
    met, waiting = set(), [DOCS / "README.md"]
    while waiting:
        path = waiting.pop()
        met.add(path)
        links = re.findall(r"\]\(([^)#\s]+\.md)", path.read_text(encoding="utf-8"))
        waiting += {(path.parent / link).resolve() for link in links} - met - set(waiting)
    assert met == set(DOCS.rglob("*.md"))


FOCUS = (DOCS / "focus.md").read_text(encoding="utf-8")
TRANSFER = {"start", "end", "strength", "curve"}  # told once for all
EXAMPLE = re.search(r"```json\n(.*?)```", FOCUS, re.DOTALL)[1]


def keys(value, path=()):
    """Paths of all keys in a JSON value; entries of a list are alike, and what a line is called is not a key."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if path[-1:] != ("kinds",):
                yield (*path, key)
            yield from keys(inner, (*path, key)) if "kinds" not in path else ()
    elif isinstance(value, list):
        for inner in value:
            yield from keys(inner, path)


def test_the_example_of_a_style_is_one_and_all_its_keys_are_known():
    found = style.parse(EXAMPLE)
    assert style.remark(found) is None and found.kept == ()


def test_the_example_has_every_key_that_a_style_can_have():
    whole = style.Style(line_sets=(style.LineSet(hidden=(style.Hidden(),)),))
    wanted = {key for key in keys(json.loads(style.dump(whole))) if key[-1] not in TRANSFER}
    # The pens of hidden lines have the keys of any pen.
    hidden = {key for key in wanted if "hidden" in key and "pen" in key}
    assert wanted - set(keys(json.loads(EXAMPLE))) - hidden == set()


def test_every_key_of_the_example_has_its_line():
    first_cells = " ".join(cells[0] for cells in rows(FOCUS))
    told = set(re.findall(r"`(\w+)`", first_cells))
    for key in ("points", "hidden"):
        told |= set(re.findall(r"`(\w+)`", row(FOCUS, key)[1]))
    used = {key[-1] for key in keys(json.loads(EXAMPLE))} - TRANSFER - {"schema", "line_sets", "distance", "effects"}
    assert used - told == set()


RECORDS = (style.Pen, style.LineSet, style.Paper, style.Color, style.Elision, style.Effects, style.Distance)
NUMBERS = {field["name"]: field for record in RECORDS for field in record.fields if "number" in field["type"]}


@pytest.mark.parametrize("key", NUMBERS)
def test_limits_of_numbers_are_told_as_they_are(key):
    told = [cells[1] for cells in rows(FOCUS) if f"`{key}`" in cells[0] and len(cells) == 2]
    if key in ("near", "far"):
        assert told  # their limits mean nothing to anyone
    else:
        least, most = (f"{NUMBERS[key][limit]:.10g}" for limit in ("min", "max"))
        assert any(f"{least} to {most}" in text for text in told), told
