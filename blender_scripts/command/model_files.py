# SPDX-License-Identifier: GPL-3.0-or-later
"""The model files that `fovea draw` takes: all that Blender imports as surfaces; and words of commands that name
files."""

import argparse
from pathlib import Path

# Suffix -> Blender's operators for it; the first that a Blender has imports the file, with its axes and its scale.
IMPORTERS = {
    ".obj": ("wm.obj_import",),
    ".ply": ("wm.ply_import",),
    ".stl": ("wm.stl_import",),
    ".gltf": ("import_scene.gltf",),
    ".glb": ("import_scene.gltf",),
    ".fbx": ("wm.fbx_import", "import_scene.fbx"),  # in C++ from Blender 4.5 on
    ".usd": ("wm.usd_import",),
    ".usda": ("wm.usd_import",),
    ".usdc": ("wm.usd_import",),
    ".usdz": ("wm.usd_import",),
    ".abc": ("wm.alembic_import",),
    ".svg": ("import_curve.svg",),
}
# Suffix -> options of these operators. glTF has a vertex once for each normal and each place in an image.
OPTIONS = dict.fromkeys((".gltf", ".glb"), {"merge_vertices": True})
APART = {".gltf", ".glb"}  # of which vertices are apart still, between flat faces and along hard edges


def is_model(spec):
    return suffix(spec) in IMPORTERS


def is_blend(spec):
    return suffix(spec) == ".blend"


def suffix(spec):
    """In lower case, as files from Windows have .OBJ and .FBX."""
    return Path(spec).suffix.lower()


def file(text):
    """The Path of a file that a word of a command names, and that has to be there."""
    path = Path(text).absolute()
    if not path.is_file():
        raise argparse.ArgumentTypeError(f"there is no file {text}")
    return path


def scene(text):
    """A word that names a scene: a file that is there, or NAME[:N]."""
    if is_blend(text) or is_model(text):
        file(text)
    return text
