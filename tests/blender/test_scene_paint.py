# SPDX-License-Identifier: GPL-3.0-or-later
"""What the project's scenes are made of has its color, whatever a Blender's Boolean modifier leaves."""

import sys
from pathlib import Path

import pytest
from the_addon import box_mesh, empty_scene

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

from scenes import palette, place, shapes


@pytest.mark.parametrize("operation", ["UNION", "DIFFERENCE"])
def test_what_is_combined_takes_the_color_that_it_is_given(operation):
    empty_scene()
    made = place.put(shapes.combine(operation, box_mesh(), shapes.moved(box_mesh(), (0.5, 0.5, 0.5))), "plaster")
    assert [material.name for material in made.data.materials] == ["Plaster"]
    assert not any(face.material_index for face in made.data.polygons)


def test_what_has_a_color_keeps_it():
    empty_scene()
    painted = box_mesh()
    painted.materials.append(palette.paint("china"))
    made = place.put(shapes.combine("UNION", painted, shapes.moved(box_mesh(), (0.5, 0.5, 0.5))), "plaster")
    assert made.data.materials[0].name == "China"
