# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of what came after Blender 4.2 says of this Blender what is true."""

import importlib.util
import sys
from pathlib import Path

import bpy
import pytest

FILE = Path(__file__).parents[1] / "python" / "later_api.py"
spec = importlib.util.spec_from_file_location("later_api", FILE)
later_api = importlib.util.module_from_spec(spec)
sys.modules[spec.name] = later_api
spec.loader.exec_module(later_api)


def properties(name):
    return getattr(bpy.types, name).bl_rna.properties.keys()


def functions(name):
    found = getattr(bpy.types, name, None)
    return found.bl_rna.functions.keys() if found else []


def items(name, member):
    return getattr(bpy.types, name).bl_rna.properties[member].enum_items_static.keys()


def engines():
    try:
        bpy.context.scene.render.engine = ""
    except TypeError as error:  # it names all that there are
        return str(error)


@pytest.mark.parametrize("later", later_api.LATER, ids=lambda later: later.use)
def test_it_is_there_from_its_version_on(later):
    there = bool(eval(later.there))
    assert there == (later.since <= bpy.app.version < later.until)
