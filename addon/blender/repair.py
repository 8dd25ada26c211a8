# SPDX-License-Identifier: GPL-3.0-or-later
"""What of an object's mesh is put in order before it is drawn."""

from dataclasses import asdict, dataclass


@dataclass(frozen=True)
class Repair:
    """native/fovea/mesh/repair.h; everything off."""

    weld: float = 0.0
    orient: bool = False
    smooth: int = 0
    resample: int = 0
    edge_length: float = 0.0

    def words(self):
        """As the native module takes them."""
        return asdict(self)


NOTHING = Repair()
REMARKS = {  # what a report counts
    "welded_vertices": "vertices were joined to others",
    "turned_polygons": "faces were turned around",
    "refused_polygons": "faces are not manifold and were left as they are",
}


def of(obj, depsgraph):
    """The Repair that the user wants for an instance's object, or None."""
    settings = obj.original.evaluated_get(depsgraph).fovea
    wanted = Repair(
        settings.repair_weld,
        settings.repair_orient,
        settings.repair_smooth,
        settings.repair_resample,
        settings.repair_edge_length if settings.repair_resample else 0.0,
    )
    return None if wanted == NOTHING else wanted


def remark(name, report):
    """One sentence about what was done, as a native RepairReport tells it, or None."""
    done = [f"{count} {words}" for what, words in REMARKS.items() if (count := getattr(report, what))]
    return f"'{name}': {'; '.join(done)}" if done else None
