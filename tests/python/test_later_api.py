# SPDX-License-Identifier: GPL-3.0-or-later
"""Nothing of Blender's API that came after 4.2 is used without a guard."""

from pathlib import Path

import pytest
from later_api import LATER, unguarded

PROJECT = Path(__file__).parents[2]
SOURCES = sorted(file for folder in ("addon", "blender_scripts") for file in (PROJECT / folder).rglob("*.py"))


def test_what_came_after_4_2_is_guarded_everywhere():
    found = [s for file in SOURCES for s in unguarded(file.read_text(), file.relative_to(PROJECT).as_posix())]
    assert found == []


@pytest.mark.parametrize(
    "text, told",
    [
        ("data.add_curves([3])", "data.add_curves is there from Blender 4.3 on"),
        ("def own(data):\n    return data.action_slot", "data.action_slot is there from Blender 4.4 on"),
        ("class A:\n    def f(self, image):\n        image.media_type = 'IMAGE'", "image.media_type is there"),
        ("bpy.ops.render(engine='BLENDER_EEVEE')", "'BLENDER_EEVEE' is there from Blender 5.0 on"),
        ("load(path, pack=True)", "pack= is there from Blender 5.0 on"),
        ("kept = bpy.data.grease_pencils", "bpy.data.grease_pencils is there from Blender 4.3 on"),
        ("def f():\n    if hasattr(gpu, 'x'):\n        gpu.init()", "gpu.init is there from Blender 5.2 on"),
    ],
)
def test_a_use_without_guard_is_found(text, told):
    found = list(unguarded(text, "addon/planted.py"))
    assert len(found) == 1 and found[0].startswith("addon/planted.py:") and told in found[0]


def test_a_guard_in_another_function_is_none():
    guarded = 'def f(image):\n    if "media_type" in image.bl_rna.properties:\n        image.media_type = "IMAGE"\n'
    assert not list(unguarded(guarded, "a.py"))
    assert len(list(unguarded(f"{guarded}\ndef g(image):\n    image.media_type = 'IMAGE'\n", "a.py"))) == 1


def test_words_of_documentation_and_names_of_icons_are_no_uses():
    text = 'def f(layout):\n    """BLENDER_EEVEE"""\n    layout.prop(icon="GREASEPENCIL")\n'
    assert not list(unguarded(text, "a.py"))


def test_all_of_the_list_came_after_4_2():
    assert all((4, 2) < later.since < later.until for later in LATER)
