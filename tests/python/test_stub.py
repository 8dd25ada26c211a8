# SPDX-License-Identifier: GPL-3.0-or-later
"""The native module is typed, and its stub for editors is up to date."""

import ast
import inspect
import re

import pytest
from command import stub
from native_core import core

RENEW = "blender_scripts/fovea stub --on sid"
MOST_FUNCTIONS = 25


def described(nodes):
    """{name: node} of what a module or class declares."""
    found = {}
    for node in nodes:
        name = node.target.id if isinstance(node, ast.AnnAssign) else getattr(node, "name", None)
        found[name] = node
    return found


@pytest.fixture(scope="module")
def declared():
    return described(ast.parse(stub.FILE.read_text(), "_native.pyi").body)


def classes():
    return [cls for _, cls in inspect.getmembers(core, inspect.isclass)]


def docstrings():
    """(name, docstring) of all functions and methods that are called by name."""
    owners = [core, *classes()]
    # Python 3.11 describes what a static method is, not what it does.
    members = [
        (f"{owner.__name__}.{name}", getattr(member, "__func__", member))
        for owner in owners
        for name, member in stub.public(owner)
    ]
    return [
        (name, m.__doc__) for name, m in members if callable(m) and " -> " in (m.__doc__ or "") and "__" not in name
    ]


def test_every_name_of_the_module_is_in_the_stub(declared):
    assert {name for name, _ in stub.public(core)} <= set(declared), f"renew it: {RENEW}"
    for cls in classes():
        inside = described(declared[cls.__name__].body)
        told = {name for name, _ in stub.public(cls) if not name.startswith("_")}
        assert told <= set(inside), f"{cls.__name__}: renew the stub: {RENEW}"


def test_the_stub_is_that_of_the_module():
    if not stub.is_typed(core):
        pytest.skip("pybind11 2 writes signatures otherwise than pybind11 3, of which the stub is made")
    assert stub.FILE.read_text() == stub.text(core), f"addon/_native.pyi is not that of the module; renew it: {RENEW}"


def test_the_module_has_few_functions_beside_its_classes():
    functions = [name for name, member in stub.public(core) if inspect.isbuiltin(member)]
    assert 0 < len(functions) <= MOST_FUNCTIONS


def test_every_argument_has_a_name():
    assert len(docstrings()) > 40
    assert not [name for name, doc in docstrings() if re.search(r"\barg\d", doc)]


def test_no_type_is_one_that_only_cpp_knows():
    assert not [name for name, doc in docstrings() if "::" in doc]


def test_results_have_names_and_not_places_in_a_tuple():
    assert not [name for name, doc in docstrings() if re.search(r"-> .*\btuple\b", doc.partition("\n")[0])]
