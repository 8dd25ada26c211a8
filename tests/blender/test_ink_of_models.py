# SPDX-License-Identifier: GPL-3.0-or-later
"""What drawings of scans and sculptures are made of; the models are not part of the project."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

from bench import ink
from command.target import SHARED


@pytest.mark.parametrize("name", ["stanford-bunny", "spot", "rocker-arm"])
def test_creases_are_at_most_a_fiftieth_of_the_ink_of_a_scan(name):
    file = SHARED / "models" / "organic" / f"{name}.obj"
    if not file.exists():
        pytest.skip(f"there is no {name}.obj among the shared models")
    row = ink.measured(str(file), "pen_and_ink")
    assert row["ink"] > 1000
    assert row["of"].get("crease", 0.0) <= 0.02, row["of"]
