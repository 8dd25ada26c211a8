# SPDX-License-Identifier: GPL-3.0-or-later
"""The documentation agrees with the program: every line definition, every key of a style, every link and picture."""

import json
import re
from pathlib import Path

import pytest
import scenes
from command import draw_options, figures, pages, tables

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
    file = DEFINITIONS[name]["file"]
    assert told == [parameter["name"] for parameter in (*DEFINITIONS[name]["parameters"], *([file] if file else []))]


@pytest.mark.parametrize("name, parameter", PARAMETERS, ids=lambda v: v if isinstance(v, str) else v["name"])
def test_a_parameter_has_its_unit_default_and_range(name, parameter):
    _, meaning, unit, default, limits = row(page(name), parameter["name"])
    low, value, high = (shown(parameter[key], parameter["unit"]) for key in ("min", "default", "max"))
    assert unit == UNITS.get(parameter["unit"], parameter["unit"]) and default == value and len(meaning) > 15
    assert limits == ("on or off" if parameter["unit"] == "bool" else f"{low} to {high}")


@pytest.mark.parametrize("name", [name for name, definition in DEFINITIONS.items() if definition["file"]])
def test_a_file_has_its_suffix(name):
    file = DEFINITIONS[name]["file"]
    _, meaning, unit, default, limits = row(page(name), file["name"])
    assert (unit, default, limits) == ("file", "none", f"ends in {file['suffix']}") and len(meaning) > 15


@pytest.mark.parametrize("page", tables.pages(catalogue, style), ids=lambda path: path.stem)
def test_tables_are_what_the_module_says(page):
    renewed = tables.pages(catalogue, style)[page]
    assert page.read_text(encoding="utf-8") == renewed, "renew it: blender_scripts/fovea stub --on sid"


def test_the_contents_are_the_registry_in_its_order():
    assert tables.LISTED.findall(page("README")) == list(DEFINITIONS)
    assert {path.stem for path in (DOCS / "lines").glob("*.md")} == {*DEFINITIONS, "README"}


def test_a_new_definition_is_in_the_contents_after_the_one_before_it():
    new = {"name": "wrinkle", "label": "Wrinkle", "description": "Where a surface is creased"}
    known = [d for d in DEFINITIONS.values() if d["name"] != "border"]
    at = [d["name"] for d in known].index("crease") + 1
    lines = tables.contents(page("README"), [*known[:at], new, *known[at:]]).split("\n")
    found = [k for k, line in enumerate(lines) if "(wrinkle.md)" in line]
    assert len(found) == 1 and "(crease.md)" in lines[found[0] - 1]
    assert not any("(border.md)" in line for line in lines)


def test_every_picture_is_drawn_by_a_script_and_there_is_no_other():
    drawn = {DOCS / pages.file_of(name) for name in pages.names()}
    drawn |= {DOCS / figures.STEPS / f"{name}.jpg" for name in pages.STEPS}
    assert {path for path in DOCS.rglob("*") if path.suffix in (".png", ".jpg")} == drawn
    assert set(pages.LINES) == set(DEFINITIONS)


@pytest.mark.parametrize("name", pages.names())
def test_a_picture_is_small(name):
    content = (DOCS / pages.file_of(name)).read_bytes()
    is_png = pages.file_of(name).endswith(".png")
    assert content.startswith(b"\x89PNG\r\n\x1a\n" if is_png else b"\xff\xd8\xff")
    assert len(content) <= (40_000 if is_png else 90_000)


@pytest.mark.parametrize("name", pages.LINES)
def test_a_line_is_shown_by_words_that_draw_understands(name):
    shown = pages.LINES[name]
    options = draw_options.parse([*shown.camera, *shown.beneath_params, *shown.params])
    assert options.azimuth is not None and set(shown.beneath) <= set(DEFINITIONS)
    if shown.model.startswith(pages.LESSON):
        lessons = (PROJECT / "blender_scripts" / "scenes" / "lessons.py").read_text(encoding="utf-8")
        assert f'"{shown.model.removeprefix(pages.LESSON)}": ' in lessons
    elif not shown.model.endswith(".obj"):
        scenes.parse(shown.model)


STAGES = pages.WAY | pages.FOCUS | pages.OVER


@pytest.mark.parametrize("name", STAGES)
def test_a_stage_is_shown_by_words_that_draw_understands(name):
    shown = STAGES[name]
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


def test_readme_has_a_zip_for_each_system_and_says_where_none_has_been_run():
    told = {cells[0]: cells[1:] for cells in rows(README.read_text(encoding="utf-8")) if "zip`" in cells[1]}
    zips = " ".join(cells[0] for cells in told.values())
    assert re.findall(r"VERSION-(\w+)\.zip", zips) == ["linux_x64", "windows_x64", "macos_arm64", "debian_SUITE"]
    untried = [name for name, (_, tried) in told.items() if tried.startswith("not yet on")]
    assert len(untried) == 2 and "Windows" in untried[0] and "macOS" in untried[1]


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


KEYS = tables.KEYS.read_text(encoding="utf-8")
EXAMPLE = re.search(r"```json\n(.*?)```", KEYS, re.DOTALL)[1]


def keys(value):
    """All keys in a JSON value, without the line definitions, which have pages, and their parameters."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield key
            yield from keys(inner) if key != "kinds" else ()
    elif isinstance(value, list):
        for inner in value:
            yield from keys(inner)


def test_the_example_of_a_style_is_one_and_all_its_keys_are_known():
    found = style.parse(EXAMPLE)
    assert style.remark(found) is None and found.kept == ()


def test_every_key_of_a_style_is_in_a_table():
    whole = style.Style(line_sets=(style.LineSet(hidden=(style.Hidden(),)),), focus=style.Focus(model="image"))
    told = {cells[0].strip("`") for cells in rows(KEYS)}
    parts = {"schema", "line_sets", "paper", "color", "elision", "focus", "effects", "distance", "animation"}
    assert {"granulation", "spacing", "from", "at"} <= told
    assert set(keys(json.loads(style.dump(whole)))) - told <= parts
    assert parts <= set(re.findall(r"`(\w+)`", KEYS))


def test_a_table_tells_label_meaning_values_and_default_of_a_key():
    assert row(KEYS, "pressure")[1:] == [
        "Pressure", "How much thinner strokes are at their ends than in the middle", "0 to 1", "0"
    ]  # fmt: skip
    assert row(KEYS, "taper")[3:] == ["0 to 10000 px", "0"] and row(KEYS, "cap")[3:] == ["`round`, `butt`", "`round`"]
    assert row(KEYS, "at")[2].startswith("In the image two numbers") and row(KEYS, "transparent")[4] == "`false`"
