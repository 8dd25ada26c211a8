# SPDX-License-Identifier: GPL-3.0-or-later
"""Which sources a self-contained module was made of. They are told beside it, as one that is older than the add-on
lacks what that asks for. Python's own library alone: a user's Blender asks, too."""

import hashlib
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
MADE_OF = ("CMakeLists.txt", "native", "shaders")


def digest():
    """Of the names and contents of all files that a module is made of."""
    found = hashlib.sha256()
    places = (place for name in MADE_OF for place in (PROJECT / name, *(PROJECT / name).rglob("*")))
    for file in sorted(place for place in places if place.is_file()):
        found.update(f"{file.relative_to(PROJECT).as_posix()}\0".encode())
        found.update(hashlib.sha256(file.read_bytes()).digest())
    return found.hexdigest()


def record(module):
    """The file beside a module that has the digest of its sources."""
    return module.with_name("sources")


def are_these(module):
    """Whether a module was made of this checkout's sources."""
    told = record(module)
    return told.is_file() and told.read_text(encoding="utf-8") == digest()
