# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of the page on scripting run, in order, as a reader would paste them."""

import importlib
import re
from pathlib import Path

import bpy
from the_addon import empty_scene, fovea, part

PAGE = Path(__file__).parents[2] / "addon" / "docs" / "scripting.md"


def test_the_examples_run(capsys):
    examples = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert len(examples) >= 8
    empty_scene()
    console = {}
    for number, example in enumerate(examples):
        code = example.replace("bl_ext.user_default.fovea", fovea.__name__)
        exec(compile(code, f"{PAGE.name}, example {number + 1}", "exec"), console)
    said = capsys.readouterr().out
    # What the page says of it.
    assert " ".join(str(4608 * 4**levels) for levels in (1, 2)) in said
    assert "(4608, 3)" in said and "(9216, 3)" in said and "True" in said.splitlines()[-2]
    assert abs(console["fields"]["k1"]).max() < 2.6 and len(console["found"]["closed"]) == 2
    assert console["file"].read_text().count("<polyline") == len(console["shapes"]) > 1
    assert {0, 1} <= set(console["runs"]["invisibility"].tolist())
    assert "</svg>" in console["svg"] and 'data-object="Torus"' in console["svg"] and "%paper" not in console["plan"]
    held = bpy.context.scene.fovea.style.fovea.line_sets["lines"]
    assert held.pen.width == 2.5 and abs(held.kinds.crease_angle - 0.698) < 1e-3


def test_scripts_find_modules_by_the_names_that_these_had_before():
    for name in ("api", "as_rendered", "session", "style_data"):
        module = part(f"{part('blender').MOVED[name]}.{name}")
        assert importlib.import_module(f"{fovea.__name__}.blender.{name}") is module
        exec(f"from {fovea.__name__}.blender import {name}", names := {})
        assert names[name] is module
    assert part("blender").session is part("render.session")
