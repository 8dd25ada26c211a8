# SPDX-License-Identifier: GPL-3.0-or-later
"""What drawings of scans and sculptures are made of; the models are not part of the project."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

from bench import ink
from command.target import SHARED


# All creases of the rocker arm are the groove around its shaft, which is whole.
@pytest.mark.parametrize("name, most", [("stanford-bunny", 0.02), ("spot", 0.02), ("rocker-arm", 0.022)])
def test_creases_are_at_most_about_a_fiftieth_of_the_ink_of_a_scan(name, most):
    file = SHARED / "models" / "organic" / f"{name}.obj"
    if not file.exists():
        pytest.skip(f"there is no {name}.obj among the shared models")
    row = ink.measured(str(file), "pen_and_ink")
    assert row["ink"] > 1000
    assert row["of"].get("crease", 0.0) <= most, row["of"]
