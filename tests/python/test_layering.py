# SPDX-License-Identifier: GPL-3.0-or-later
"""Who may include or import whom: the folders stand in the order of the data, and each foreign library has one door."""

import ast
import re
import shutil
from pathlib import Path

import pytest

PROJECT = Path(__file__).parents[2]

# A native folder includes itself and those before it.
NATIVE = "base raster mesh field scene repair image line style path project visibility runs focus elision stroke color draw".split()

# What uses the core: each includes itself and all of the core.
USERS = ("bindings", "tool")

# Header -> where it may be included.
LIBRARIES = {
    r"pybind11/": r"native/bindings/",
    r"numpy/": r"native/bindings/",
    r"OpenSubdiv|opensubdiv/": r"native/fovea/mesh/refine",
    r"OpenMesh/": r"native/fovea/repair/",
    r"tbb/parallel_": r"native/fovea/base/parallel",
    r"embree\d?/": r"native/fovea/scene/bvh",
    r"CLI/": r"native/tool/",
    r"nlohmann/": r"native/(tool/|fovea/style/json|fovea/draw/assets)",
    r"Python\.h": r"nowhere",
}

# Python module -> where it may be imported.
DOORS = {
    "bpy": r"addon/blender/",
    "bmesh": r"addon/blender/",
    "mathutils": r"addon/blender/",
    "bpy_extras": r"addon/blender/",
    "gpu": r"addon/backend/gpu\w*\.py",
    "gpu_extras": r"addon/backend/gpu\w*\.py",
    "addon": r"nowhere",  # the package has another name once it is installed: imports in it are relative
    "bl_ext": r"nowhere",
    "tests": r"nowhere",
    "scenes": r"nowhere",
    "command": r"nowhere",
}

# The add-on's own parts -> those they may import; a folder stands for all that is in it.
PARTS = {
    "__init__": "blender",
    "stages": "",
    "native": "_native",
    "style": "catalogue native",
    "catalogue": "native",
    "line_arrays": "native",
    "still_life": "",
    "curve_fit": "",
    "backend/cpu": "native",
    "backend/gpu": "backend/gpu native stages",
    "pipeline": "native stages style",
    "budget": "catalogue",
    "blender": "blender backend budget catalogue curve_fit line_arrays native pipeline stages still_life style",
}

# `native.load()` gives the native module; other parts get handles from these.
LOADERS = (
    r"addon/(backend/(cpu|gpu\w*)|catalogue|line_arrays|pipeline|style|"
    r"blender/(api|drawn_lines|preferences|reading|scene|session|style_picture|viewport))\.py"
)


def violations(root):
    """A sentence for every include and import that breaks a rule."""
    return [*_native_violations(root), *_python_violations(root)]


def _native_violations(root):
    for file in sorted((root / "native").rglob("*")):
        if file.suffix not in (".h", ".cpp"):
            continue
        name = file.relative_to(root).as_posix()
        folder = file.parent.relative_to(root / "native").as_posix().removeprefix("fovea/")
        if folder not in (*NATIVE, *USERS):
            yield f"{name}: the folder {folder} is not in the order of the data"
            continue
        before = NATIVE[: NATIVE.index(folder) + 1] if folder in NATIVE else [*NATIVE, folder]
        for header in re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', file.read_text(), re.M):
            other = header.removeprefix("fovea/").split("/")[0]
            if other in (*NATIVE, *USERS) and other not in before:
                yield f"{name} includes {header}, which comes after it"
            for library, door in LIBRARIES.items():
                if re.match(library, header) and not re.match(door, name):
                    yield f"{name} includes {header}, allowed only in {door}"


def _python_violations(root):
    for file in sorted((root / "addon").rglob("*.py")):
        name = file.relative_to(root).as_posix()
        tree = ast.parse(file.read_text(), name)
        if "native.load" in (ast.unparse(n) for n in ast.walk(tree) if isinstance(n, ast.Attribute)):
            if not re.fullmatch(LOADERS, name):
                yield f"{name} loads the native module"
        for module in _imports(tree, file.relative_to(root / "addon")):
            if module.startswith("."):
                if not _may_import(name.removeprefix("addon/").removesuffix(".py"), module[1:]):
                    yield f"{name} imports {module[1:]}"
            elif not re.match(DOORS.get(module.split(".")[0], ""), name):
                yield f"{name} imports {module}, allowed only in {DOORS[module.split('.')[0]]}"


def _imports(tree, file):
    """Names of imported modules; those of the add-on as '.folder/module'."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield node.module
        elif isinstance(node, ast.ImportFrom):
            base = file.parents[node.level - 1].as_posix().removeprefix(".")
            inside = "/".join(filter(None, [base, (node.module or "").replace(".", "/")]))
            folder = not node.module or inside in ("backend", "blender")
            names = ["/".join(filter(None, [inside, alias.name])) for alias in node.names]
            yield from ("." + module for module in (names if folder else [inside]))


def _may_import(importer, imported):
    matches = [part for part in PARTS if importer == part or importer.startswith((part + "/", part + "_"))]
    if importer == "backend/__init__":
        return True
    if not matches:
        return False
    allowed = PARTS[max(matches, key=len)].split()
    return any(imported == part or imported.startswith((part + "/", part + "_")) for part in allowed)


def test_readme_names_the_native_folders_in_their_order():
    assert " ".join(NATIVE) in (PROJECT / "README.md").read_text(encoding="utf-8")


def test_the_rules_hold():
    assert not list(violations(PROJECT))


@pytest.mark.parametrize(
    "file, text, complaint",
    [
        ("native/fovea/mesh/planted.cpp", "#include <fovea/line/segments.h>", "which comes after it"),
        ("native/fovea/line/planted.cpp", "#include <pybind11/numpy.h>", "allowed only in native/bindings/"),
        (
            "native/fovea/visibility/planted.cpp",
            "#include <embree4/rtcore.h>",
            "allowed only in native/fovea/scene/bvh",
        ),
        (
            "native/fovea/color/planted.cpp",
            "#include <tbb/parallel_for.h>",
            "allowed only in native/fovea/base/parallel",
        ),
        ("native/fovea/color/planted.cpp", "#include <tool/model.h>", "which comes after it"),
        ("native/tool/planted.cpp", "#include <bindings/bind.h>", "which comes after it"),
        ("native/fovea/base/planted.cpp", "#include <nlohmann/json.hpp>", "allowed only in native/(tool/"),
        ("native/surprise/planted.h", "", "not in the order of the data"),
        ("addon/planted.py", "import bpy", "imports bpy"),
        ("addon/pipeline.py", "from .backend import gpu", "imports backend/gpu"),
        ("addon/backend/cpu.py", "import gpu", "imports gpu"),
        ("addon/backend/gpu_planted.py", "from ..blender import scene", "imports blender/scene"),
        ("addon/curve_fit.py", "from . import native\nnative.load()", "loads the native module"),
        ("addon/stages.py", "def late():\n    from .style import Pen", "imports style"),
        ("addon/blender/planted.py", "import addon.style", "imports addon.style"),
    ],
)
def test_a_broken_rule_is_found(tmp_path, file, text, complaint):
    for folder in ("native", "addon"):
        shutil.copytree(PROJECT / folder, tmp_path / folder)
    planted = tmp_path / file
    planted.parent.mkdir(parents=True, exist_ok=True)
    planted.write_text(text)
    assert any(file in sentence and complaint in sentence for sentence in violations(tmp_path))
