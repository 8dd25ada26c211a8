# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea stub`: writes addon/_native.pyi, the type stub of the native module for editors and type checkers, from the
signatures and docstrings that pybind11 generates; and the tables of addon/docs that follow from the module."""

import argparse
import ast
import importlib
import re
import sys
import textwrap
import types

from . import package, tables
from .target import PROJECT, StepFailed

FILE = PROJECT / "addon" / "_native.pyi"
WIDTH = 120
HEAD = '''# SPDX-License-Identifier: GPL-3.0-or-later
# Made by `fovea stub` of what the module says of itself; not to be edited.
"""{doc}"""

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Annotated, ClassVar, overload

import numpy
from numpy.typing import ArrayLike, NDArray
'''
SPOKEN = ("__init__", "__call__", "__len__", "__eq__", "__hash__", "__int__", "__or__", "__and__")
# Pattern in pybind11's signatures -> replacement in the stub.
WORDS = (
    (r"\b(\w+\.)*_native\.", ""),
    (r"\b(numpy\.typing|collections\.abc|typing)\.", ""),
    (r"\bSupportsFloat \| SupportsIndex", "float"),
    (r"\bSupportsInt \| SupportsIndex", "int"),
    (r"<[^<>]* object at 0x\w+>", "..."),
    (r"\barg0\b", "other"),  # of operators
)


def stub(target, words):
    argparse.ArgumentParser("fovea stub").parse_args(words)
    package.stage(target)
    sys.path.insert(0, str(package.importable(target)))
    module = importlib.import_module("addon.native").load()
    if not is_typed(module):
        raise StepFailed("the stub is made where pybind11 is 3 or later: blender_scripts/fovea stub --on sid")
    FILE.write_text(text(module))
    print(FILE)
    catalogue, style = (importlib.import_module(f"addon.{name}") for name in ("catalogue", "style"))
    for page, renewed in tables.pages(catalogue, style).items():
        page.write_text(renewed, encoding="utf-8")
        print(page)
    return 0


def is_typed(module):
    """Whether a module's signatures are from pybind11 3; version 2 writes other types."""
    return "numpy.typing" in module.png_bytes.__doc__


def text(module):
    """The stub of a module."""
    return "\n\n".join([HEAD.format(doc=module.__doc__.strip()), *of_members(module)]) + "\n"


def of_members(module):
    """Yields the stub text of each member of a module; a submodule is written as a class, to keep one file."""
    for name, member in public(module):
        if isinstance(member, types.ModuleType):
            inner = "\n\n".join(of_members(member))
            head = "\n".join([f"class {name}:", *documented(member.__doc__, "    ")])
            yield f"{head}\n\n{textwrap.indent(inner, '    ')}"
        elif isinstance(member, type):
            yield "\n".join(of_class(name, member))
        elif callable(member):
            yield "\n".join(of_function(member.__doc__, ""))
        else:
            yield f"{name}: {type(member).__name__}"


def public(owner):
    """(name, member) of a module or class in definition order, without private members and special methods except
    SPOKEN."""
    return [(name, member) for name, member in vars(owner).items() if name in SPOKEN or not name.startswith("_")]


def of_class(name, cls):
    """Yields the lines of a class."""
    base = cls.__base__.__name__ if cls.__base__.__name__ != "pybind11_object" else "object"
    yield f"class {name}:" if base == "object" else f"class {name}({base}):"
    doc = re.split(r"\n\nMembers:", cls.__doc__ or "")[0]
    yield from documented(doc, "    ")
    empty = not doc
    for key, member in public(cls):
        lines = list(of_member(cls, key, member))
        empty &= not lines
        yield from lines
    if empty:
        yield "    ..."


def of_member(cls, key, member):
    if isinstance(member, property):
        kind = signatures(member.fget.__doc__)[0].partition(" -> ")[2]
        doc = "" if member.__doc__ == member.fget.__doc__ else member.__doc__
        yield "    @property"
        yield from declared(f"{key}(self) -> {kind}", doc or "", "    ")
        if member.fset:
            yield f"    @{key}.setter"
            yield from declared(f"{key}(self, value: {kind}) -> None", "", "    ")
    elif isinstance(member, (int, float, tuple, cls)):
        kind = cls.__name__ if isinstance(member, cls) else type(member).__name__
        yield f"    {key}: ClassVar[{kind}]"
    elif isinstance(member, staticmethod):
        yield from of_function(member.__func__.__doc__, "    ", "@staticmethod")
    elif type(member).__name__ == "instancemethod":
        yield from of_function(member.__doc__, "    ")


def of_function(doc, indent, *decorators):
    """Yields the lines of a function or its overloads, from its docstring."""
    found = signatures(doc)
    for signature in found:
        yield from (f"{indent}{decorator}" for decorator in decorators)
        if len(found) > 1:
            yield f"{indent}@overload"
        yield from declared(signature, doc.partition("\n")[2] if len(found) == 1 else "", indent)


def signatures(doc):
    """NAME(ARGUMENTS) -> TYPE for each overload in a docstring, or from its first line, with WORDS applied."""
    lines = doc.splitlines()
    found = re.findall(r"^\d+\. (.*)$", doc, re.M) if lines[1:2] == ["Overloaded function."] else lines[:1]
    for pattern, meant in WORDS:
        found = [re.sub(pattern, meant, line) for line in found]
    return found


def declared(signature, doc, indent):
    """Yields the lines of a function with a signature; parameters with default None get the type `| None`."""
    (function,) = ast.parse(f"def {signature}: ...").body
    arguments = function.args
    positional = [*arguments.posonlyargs, *arguments.args]
    if positional and positional[0].arg == "self":
        positional[0].annotation = None
    pairs = list(zip(reversed(positional), reversed(arguments.defaults), strict=False))
    for argument, default in [*pairs, *zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)]:
        if is_none(default) and not any(map(is_none, ast.walk(argument.annotation))):
            argument.annotation = ast.BinOp(argument.annotation, ast.BitOr(), ast.Constant(None))
    head = ast.unparse(function).splitlines()[0]
    lines = [head]
    if len(indent + head) > WIDTH:
        opening, inside, closing = re.fullmatch(r"(def \w+\()(.*)(\) -> .*)", head).groups()
        lines = [opening, *(f"    {one}," for one in re.split(r", (?=\*|\w+: )", inside)), closing]
    if not doc.strip():
        lines[-1] += " ..."
    yield from (indent + line for line in lines)
    yield from documented(doc, indent + "    ")


def is_none(node):
    return isinstance(node, ast.Constant) and node.value is None


def documented(text, indent):
    """Yields the lines of a docstring; none if it is empty."""
    text = " ".join(text.split())
    if text:
        yield from textwrap.wrap(
            f'"""{text}"""', WIDTH, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False
        )
