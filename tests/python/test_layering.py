# SPDX-License-Identifier: GPL-3.0-or-later
"""Which folders may include or import which: in the order of the data, and each foreign library in one place only."""

import ast
import functools
import re
import shutil
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

PROJECT = Path(__file__).parents[2]

# A native folder includes itself and those before it.
NATIVE = (
    "base raster mesh field scene repair cutout image line style path project visibility runs focus elision stroke "
    "color draw vector study"
).split()

# What stands beside the core: each includes itself and all of the core.
USERS = ("bindings", "tool", "standalone")

# Header -> where it may be included.
LIBRARIES = {
    r"pybind11/": r"native/bindings/",
    r"numpy/": r"native/bindings/",
    r"OpenSubdiv|opensubdiv/": r"native/fovea/mesh/refine",
    r"OpenMesh/": r"native/fovea/repair/",
    r"tbb/parallel_": r"native/fovea/base/parallel",
    r"embree\d?/": r"native/fovea/scene/bvh",
    r"CLI/": r"native/tool/",
    r"nlohmann/": r"native/(tool/|fovea/style/json)",
    r"zlib\.h": r"native/fovea/vector/pdf",
    r"png\.h": r"native/fovea/color/(stored_)?png",
    r"Python\.h": r"nowhere",
}

# Python module -> where it may be imported.
BLENDER = r"addon/(scene|focus|style(?!/__init__)|render|ui)/"
DOORS = {
    "bpy": BLENDER,
    "bmesh": BLENDER,
    "mathutils": BLENDER,
    "bpy_extras": BLENDER,
    "gpu": r"addon/gpu/",
    "gpu_extras": r"addon/gpu/",
    "addon": r"nowhere",  # the package has another name once it is installed: imports in it are relative
    "bl_ext": r"nowhere",
    "tests": r"nowhere",
    "scenes": r"nowhere",
    "command": r"nowhere",
}

# The add-on's modules that need no Blender -> those they may import. `style` is the __init__ of its folder.
MODULES = {
    "__init__": "",
    "stages": "",
    "files": "",
    "gauges": "",
    "gauge_practice": "gauges",
    "gauge_session": "files gauges",
    "frame_records": "held_folder",
    "held_folder": "",
    "native": "_native",
    "style": "catalogue line_files native",
    "line_files": "catalogue files learned_lines",
    "catalogue": "native",
    "line_arrays": "native",
    "comparison": "native paper_scale registered_drawing svg_drawing",
    "registered_drawing": "",
    "paper_scale": "",
    "svg_drawing": "paper_scale",
    "comparison_report": "files native",
    "explained_lines": "",
    "fitted_style": "catalogue fitted_hand fitted_pens native style",
    "fitted_hand": "native stages style",
    "fitted_pens": "stages",
    "learned_lines": "native",
    "gaze": "files heat_map native",
    "heat_map": "",
    "still_life": "",
    "curve_fit": "native",
    "pipeline": "line_files native stages style",
    "budget": "catalogue",
    "moved_picture": "",
}
# Its folders: each imports itself, those before it, and all modules; `gpu` only the module of the core.
FOLDERS = "gpu scene focus style render ui".split()

# `native.load()` gives the native module; other parts get handles from these.
LOADERS = (
    r"addon/(gpu/\w+|catalogue|comparison(_report)?|curve_fit|fitted_(hand|style)|gaze|learned_lines|line_arrays|pipeline|scene/api|ui/preferences|"
    r"style/(__init__|style_picture)|render/(bake_operators|definition_strengths|drawn_lines|gaze_check|gpu_check|"
    r"line_operators|local_properties|marks_operators|methods|motion_blur|near_frames|reading|session|style_fit|vector_settings|vectors|viewport|whole_pictures"
    r"))\.py"
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
        for namespace in re.findall(r"^namespace fovea(?:::(\w+))?(?:::\w+)* \{", file.read_text(), re.M):
            # The words of an enumeration belong to style, whoever declares it.
            if namespace not in (folder, "style") and name != "native/fovea/base/namespaces.h":
                yield f"{name} has the namespace fovea::{namespace}"
        for header in re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', file.read_text(), re.M):
            other, inside, _ = header.removeprefix("fovea/").partition("/")
            if inside and other in (*NATIVE, *USERS) and other not in before:
                yield f"{name} includes {header}, which comes after it"
            for library, door in LIBRARIES.items():
                if re.match(library, header) and not re.match(door, name):
                    yield f"{name} includes {header}, allowed only in {door}"


def _python_violations(root):
    imported = {}  # module of the add-on: those it imports
    for file in sorted((root / "addon").rglob("*.py")):
        name = file.relative_to(root).as_posix()
        nodes = _nodes(file.read_text())
        if any(isinstance(node, ast.Attribute) for node in nodes) and not re.fullmatch(LOADERS, name):
            yield f"{name} loads the native module"
        importer = _module(file.relative_to(root / "addon"))
        imported[importer] = []
        for module in _imports(nodes, file.relative_to(root / "addon"), root / "addon"):
            if module.startswith("."):
                imported[importer].append(module[1:])
                if not _may_import(importer, module[1:]):
                    yield f"{name} imports {module[1:]}"
            elif not re.match(DOORS.get(module.split(".")[0], ""), name):
                yield f"{name} imports {module}, allowed only in {DOORS[module.split('.')[0]]}"
    try:
        TopologicalSorter(imported).prepare()
    except CycleError as error:
        yield f"modules import each other: {' '.join(error.args[1])}"


@functools.cache  # each test reads all files, of which it has changed one
def _nodes(text):
    """The imports in a Python file, and each `native.load`."""

    def is_load(node):
        return isinstance(node, ast.Attribute) and node.attr == "load" and getattr(node.value, "id", "") == "native"

    return [
        node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Import | ast.ImportFrom) or is_load(node)
    ]


def _module(file):
    """A file of the add-on as imports name it: 'folder/module', 'folder', or '__init__' of the add-on itself."""
    name = file.with_suffix("").as_posix()
    return name.removesuffix("/__init__")


def _imports(nodes, file, root):
    """Names of imported modules; those of the add-on as '.folder/module'."""
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield node.module
        elif isinstance(node, ast.ImportFrom):
            base = file.parents[node.level - 1].as_posix().removeprefix(".")
            inside = "/".join(filter(None, [base, (node.module or "").replace(".", "/")]))
            for alias in node.names:
                name = "/".join(filter(None, [inside, alias.name]))
                is_module = (root / f"{name}.py").exists() or (root / name).is_dir()
                yield "." + (name if is_module else inside)


def _may_import(importer, imported):
    if importer in MODULES:
        return imported in MODULES[importer].split()
    folder, other = importer.split("/")[0], imported.split("/")[0]
    if folder not in FOLDERS:
        return False
    if imported in MODULES:
        return folder != "gpu" or imported == "native"
    return other in FOLDERS[: FOLDERS.index(folder) + 1]


def copy_sources(to):
    """Without documents, pictures and data."""
    for folder in ("native", "addon"):
        others = shutil.ignore_patterns("docs", "*.jpg", "*.png", "*.json")
        shutil.copytree(PROJECT / folder, to / folder, ignore=others)


def test_readme_names_the_native_folders_in_their_order():
    assert " ".join(NATIVE) in (PROJECT / "README.md").read_text(encoding="utf-8")


def test_namespaces_see_those_of_the_folders_before_them():
    """Names of style are called by its name: strokes have a Pen, too. Study stands apart: nothing depends on it."""
    text = (PROJECT / "native/fovea/base/namespaces.h").read_text()
    told = re.findall(r"namespace (\w+) \{\s*(?:using namespace (\w+);)?", text.replace("namespace fovea {", ""))
    drawing = [folder for folder in NATIVE if folder != "study"]
    seen = [folder for folder in drawing if folder != "style"]
    before = dict(zip(seen, ["", *seen])) | {"style": "line"}
    assert told == [(folder, before[folder]) for folder in drawing]


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
        ("native/fovea/path/planted.h", "namespace fovea::line {", "has the namespace fovea::line"),
        ("native/fovea/path/planted.h", "namespace fovea::line::inner {", "has the namespace fovea::line"),
        ("native/fovea/path/planted.h", "namespace fovea {", "has the namespace fovea::"),
        ("addon/planted.py", "import bpy", "imports bpy"),
        ("addon/style/__init__.py", "import bpy", "imports bpy"),
        ("addon/pipeline.py", "from .gpu import backend", "imports gpu/backend"),
        ("addon/scene/camera.py", "import gpu", "imports gpu"),
        ("addon/gpu/planted.py", "from ..scene import scene", "imports scene/scene"),
        ("addon/gpu/planted.py", "from .. import style", "imports style"),
        ("addon/scene/planted.py", "from ..style import style_data", "imports style/style_data"),
        ("addon/style/planted.py", "from ..ui.preferences import apply", "imports ui/preferences"),
        ("addon/budget.py", "from . import native\nnative.load()", "loads the native module"),
        ("addon/stages.py", "def late():\n    from .style import Pen", "imports style"),
        ("addon/scene/planted.py", "import addon.style", "imports addon.style"),
        ("addon/planted/file.py", "from .. import native", "imports native"),
    ],
)
def test_a_broken_rule_is_found(tmp_path, file, text, complaint):
    copy_sources(tmp_path)
    planted = tmp_path / file
    planted.parent.mkdir(parents=True, exist_ok=True)
    planted.write_text(text)
    assert any(file in sentence and complaint in sentence for sentence in violations(tmp_path))


def test_modules_that_import_each_other_are_found(tmp_path):
    copy_sources(tmp_path)
    (tmp_path / "addon/scene/problem.py").write_text("def late():\n    from .camera import of_scene")
    assert any(
        "scene/camera scene/problem scene/camera" in s or "scene/problem scene/camera" in s
        for s in violations(tmp_path)
    )
