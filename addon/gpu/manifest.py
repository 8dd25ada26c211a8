# SPDX-License-Identifier: GPL-3.0-or-later
"""What shaders/programs.toml says of the shader programs. Needs neither Blender nor the native module."""

import tomllib
from functools import cache
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parents[1]


@cache
def _folder():
    """Folder of the shaders: inside the installed extension, or beside it in a checkout."""
    for folder in (_PACKAGE / "shaders", _PACKAGE.parent / "shaders"):
        if (folder / "programs.toml").is_file():
            return folder
    raise FileNotFoundError(f"Fovea's shaders are missing from {_PACKAGE}; install the extension again")


@cache
def programs():
    """{program: description}, each merged over that of the program in its `like` entry."""
    described = tomllib.loads((_folder() / "programs.toml").read_text())

    def whole(name):
        said = described[name]
        return {**(whole(said["like"]) if "like" in said else {}), **said}

    return {name: whole(name) for name in described}


def source(files):
    """The source of a stage, joined from its files."""
    return "\n".join((_folder() / file).read_text() for file in files)
