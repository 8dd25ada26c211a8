# SPDX-License-Identifier: GPL-3.0-or-later
"""What the frames of a render are made from, as a hash: renders with equal keys, of the same frame, are equal.

It is of the Blender file's bytes, the extension's files, the Blender, and what a command line may set otherwise than
the file. What the file links to or loads, as libraries, images and simulations, is not looked at."""

import hashlib
import json
import os
from functools import cache, lru_cache
from pathlib import Path

import bpy

from .. import native

ADDON = Path(__file__).parents[1]


def key_of(scene):
    """The key of the scene's frames, in hexadecimal."""
    file, render = Path(bpy.data.filepath), scene.render
    image = render.image_settings
    parts = {
        "file": _digest(file, file.stat().st_mtime_ns).hex() if file.is_file() else "",
        "scene": scene.name,
        "build": build(),
        "blender": blender(),
        "backend": os.environ.get("FOVEA_BACKEND", ""),
        "engine": render.engine,
        "size": [render.resolution_x, render.resolution_y, render.resolution_percentage],
        "format": [image.file_format, image.color_mode, image.color_depth],
    }
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def blender():
    return f"{bpy.app.version_string} {bpy.app.build_hash.decode()}".strip()


@lru_cache(maxsize=1)
def build():
    """A hash of the extension's files, in hexadecimal."""
    files = [path for path in ADDON.rglob("*") if path.is_file() and path.suffix != ".pyc"]
    digest = hashlib.sha256()
    for file in sorted({*files, *filter(None, [native.place()])}):
        digest.update(_digest(file, file.stat().st_mtime_ns))
    return digest.hexdigest()[:16]


@cache
def _digest(file, _changed):
    with file.open("rb") as opened:
        return hashlib.file_digest(opened, "sha256").digest()
