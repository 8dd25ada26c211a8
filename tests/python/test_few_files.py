# SPDX-License-Identifier: GPL-3.0-or-later
"""An addition to the program touches few files: those that name it, counted in the code without its comments."""

import re
from functools import cache
from pathlib import Path

import pytest

from addon import catalogue, style

PROJECT = Path(__file__).parents[2]
FOLDERS = ("native/fovea", "native/bindings", "native/tool", "addon", "shaders")
# Words of the style files that scripts, importers and panels may use as everyone does.
USERS = ("addon/style/__init__.py", "addon/style/freestyle.py", "addon/style/line_art.py")
USERS += ("addon/style/line_style_modifiers.py", "addon/scene/api.py", "addon/ui/")
COMMENTS = {
    ".py": re.compile(r'""".*?"""|#[^\n]*', re.DOTALL),
    ".glsl": re.compile(r"//[^\n]*"),
    ".h": re.compile(r"//[^\n]*"),
    ".cpp": re.compile(r"//[^\n]*"),
}


@cache
def sources():
    """{file: its code without comments}."""
    found = (path for folder in FOLDERS for path in (PROJECT / folder).rglob("*") if path.suffix in COMMENTS)
    texts = {path.relative_to(PROJECT).as_posix(): COMMENTS[path.suffix].sub("", path.read_text()) for path in found}
    return {file: text for file, text in texts.items() if not file.startswith(USERS)}


def naming(pattern):
    return sorted(file for file, text in sources().items() if re.search(pattern, text))


TWINS = {n for d in catalogue.definitions() for n in (d["smooth_twin"], *d["stand_ins"])}


@pytest.mark.parametrize("name", sorted(set(catalogue.by_name()) - TWINS))
def test_a_line_definition_is_one_file_and_a_line_of_the_list(name):
    """Those that others stand for are named by these, too."""
    assert naming(rf'"{name}"|\bdefine\({name}\)|LineDefinition {name}\b') == sorted(
        ["native/fovea/line/registry.cpp", f"native/fovea/line/{name}.cpp"]
    )


NUMBERS = [f["name"] for f in style.Pen.fields if f["type"] == "number"]


@pytest.mark.parametrize("name", sorted(set(NUMBERS) - {"width", "opacity"}))
def test_a_number_of_a_pen_is_its_declaration_and_its_use(name):
    """Of others than those by which styles are mixed and strokes are as wide as they are."""
    files = naming(rf"\bPen::{name}\b|\b(look|pen|pen_away)(\.|->){name}\b")
    assert "native/fovea/style/pen.h" in files and len(files) == 2, files


@pytest.mark.parametrize("name", [f["name"] for f in style.Effects.fields if f["type"] == "transfer"])
def test_an_effect_is_its_declaration_and_what_answers(name):
    files = naming(rf"\bEffects::{name}\b|\beffects(\.|->){name}\b")
    assert "native/fovea/style/focus.h" in files and len(files) <= 3, files


def test_every_kind_of_focus_is_in_the_core_and_in_the_table_of_blenders():
    (model,) = (f for f in style.Focus.fields if f["name"] == "model")
    table = sources()["addon/focus/focus_kinds.py"]
    assert [name.upper() for name, *_ in model["choices"]] == re.findall(
        r'^    "([A-Z]+)": Kind\(', table, re.MULTILINE
    )


@pytest.mark.parametrize("name", [name for f in style.Focus.fields for name, *_ in f.get("choices", ())])
def test_a_kind_of_focus_is_its_declaration_and_an_entry_of_a_table(name):
    """Of several places together: what is done with them, too."""
    of_focus = naming(r"\bFocusModel\b|\bfocus_model\b|\bCombine\b|\bfocus_combine\b|\bfocus_kinds\b|\bclass Kind\b")
    files = set(naming(rf'\bFocusModel::{name}\b|\bCombine::{name}\b|"{name}"|"{name.upper()}"')) & set(of_focus)
    assert "native/fovea/style/focus.h" in files and len(files) <= 4, files
