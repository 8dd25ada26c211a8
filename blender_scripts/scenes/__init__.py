# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes by name: `demo`, `office`, `boxes:N`, `suzanne:L`, and the situations of addon/docs/situations.md.

Importing this package needs no Blender; building does."""

import importlib
from pathlib import Path

# Name -> default argument. None: the scene takes no argument.
DEFAULTS = {"demo": None, "office": None, "boxes": 100, "suzanne": 5} | {
    "foliage": 260, "hair": 2000, "hull": None, "scan": 5, "parts": None, "runner": None, "grove": 400,
    "lettering": None, "night": None,
}  # fmt: skip
# Range of arguments; the maximum gives over ten million triangles.
RANGES = {"boxes": (1, 1000), "suzanne": (0, 7), "hair": (1, 1_000_000)} | {
    "foliage": (1, 100_000), "scan": (0, 7), "grove": (1, 100_000),
}  # fmt: skip


def names() -> list[str]:
    return list(DEFAULTS)


def parse(spec: str) -> tuple[str, int | None]:
    """'boxes:100' -> ('boxes', 100). ValueError if it is not a scene."""
    name, colon, argument = spec.partition(":")
    if name not in DEFAULTS:
        raise ValueError(f"no scene is called '{name}'; there are {', '.join(names())}")
    if not colon:
        return name, DEFAULTS[name]
    if DEFAULTS[name] is None or not argument.isdecimal():
        example = name if DEFAULTS[name] is None else f"{name}:{DEFAULTS[name]}"
        raise ValueError(f"'{spec}' is no scene; try '{example}'")
    least, most = RANGES[name]
    if not least <= int(argument) <= most:
        raise ValueError(f"'{spec}' is no scene: N of {name}:N is a number from {least} to {most}")
    return name, int(argument)


def build(spec: str, shared: Path | None = None):
    """Builds the scene in the open Blender file, replacing what is there. `shared`: models not in the project."""
    name, argument = parse(spec)
    importlib.import_module(f"{__name__}.{name}").build(argument, shared)
