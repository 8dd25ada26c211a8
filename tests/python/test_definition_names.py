# SPDX-License-Identifier: GPL-3.0-or-later
"""A line definition is one file and one line in the registry: no other code refers to it by name."""

import ast
import re
from pathlib import Path

import pytest

from addon import catalogue

PROJECT = Path(__file__).parents[2]
NAMES = frozenset(catalogue.by_name())
LINES = PROJECT / "native" / "fovea" / "line"
EXEMPT = {
    "addon/style/freestyle.py": "an importer: a table says which lines Freestyle's edge types are",
    "addon/style/line_art.py": "an importer: a table says which lines Line Art's edge types are",
}


def code_of(path):
    """C++ without comments."""
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", path.read_text(), flags=re.S)


def named_in_cpp(path):
    """Definitions that a C++ file names in strings, but for its own; outside of native/fovea/line also as constants."""
    text = code_of(path)
    found = set(re.findall(r'"(\w+)"', text)) & NAMES
    if path.parent != LINES:
        for declared in re.findall(r"extern const LineDefinition ([^;]*);", text):
            found |= set(re.findall(r"\w+", declared)) & NAMES
    return found - {path.stem}


def named_in_python(path):
    """Definitions that a Python file names in strings or as attributes; docstrings are not code."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            found.add(node.value)
        elif isinstance(node, ast.Attribute):
            found.add(node.attr)
    return found & NAMES


def complaints(root):
    for path in sorted([*(root / "native").rglob("*.cpp"), *(root / "native").rglob("*.h")]):
        yield from ((path.relative_to(root).as_posix(), name) for name in sorted(named_in_cpp(path)))
    for path in sorted((root / "addon").rglob("*.py")):
        yield from ((path.relative_to(root).as_posix(), name) for name in sorted(named_in_python(path)))


def test_no_code_but_its_own_file_names_a_line_definition():
    found = [(file, name) for file, name in complaints(PROJECT) if file not in EXEMPT]
    assert not found, f"what others must know of a definition is a member of LineDefinition: {found}"
    assert all((PROJECT / file).is_file() for file in EXEMPT)


@pytest.mark.parametrize(
    "file, text",
    [
        ("native/fovea/path/planted.cpp", 'auto i = definition_index("crease");'),
        ("native/fovea/elision/planted.h", "extern const LineDefinition contour, border;"),
        ("addon/planted.py", 'slow = {"silhouette"}'),
        ("addon/scene/planted.py", "def drawn(kinds):\n    return kinds.crease"),
    ],
)
def test_a_definition_that_is_named_elsewhere_is_found(tmp_path, file, text):
    (tmp_path / file).parent.mkdir(parents=True)
    (tmp_path / file).write_text(text)
    assert [found for found, _ in complaints(tmp_path)]


@pytest.mark.parametrize("name", sorted(NAMES))
def test_a_definition_is_one_file_and_one_line_of_the_registry(name):
    assert f'.name = "{name}"' in code_of(LINES / f"{name}.cpp")
    constant = rf"(?<!::)\b{name}\b"  # but not a member of something else that has the same name
    lines = [line for line in code_of(LINES / "registry.cpp").splitlines() if re.search(constant, line)]
    assert len(lines) == 1, lines
