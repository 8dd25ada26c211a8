# SPDX-License-Identifier: GPL-3.0-or-later
"""The model files that `fovea draw` takes: all that Blender imports as surfaces."""

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
# Operator -> its options. Files of glTF have a vertex for each texture coordinate: seams are no ends of surfaces.
OPTIONS = {"import_scene.gltf": {"merge_vertices": True}}


def is_model(spec):
    return suffix(spec) in IMPORTERS


def is_blend(spec):
    return suffix(spec) == ".blend"


def suffix(spec):
    """In lower case, as files from Windows have .OBJ and .FBX."""
    return Path(spec).suffix.lower()
