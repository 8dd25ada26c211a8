# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings for repairing an object's mesh before drawing, as far as Blender has no modifier for it."""

from dataclasses import asdict, dataclass


@dataclass(frozen=True)
class Repair:
    """As in native/fovea/repair/repair.h; the defaults repair nothing."""

    orient: bool = False
    resample: int = 0
    edge_length: float = 0.0

    def words(self):
        """As keyword arguments of the native RepairedMesh."""
        return asdict(self)


# A mesh of which resampling makes more is not resampled: 6 GB are needed meanwhile. It is the same on every machine and
# with every Memory Limit, because pictures may not depend on these.
MOST_TRIANGLES = 10_000_000
REMARKS = {  # counts of a native RepairReport -> text
    "turned_polygons": "faces were turned around",
    "refused_polygons": "faces are not manifold and were left as they are",
    "too_many_triangles": f"triangles are more than {MOST_TRIANGLES:,}, so it was not resampled: "
    "set a longer Edge Length",
}
REMOVED = {"repair_weld": "Weld", "repair_smooth": "Smooth"}  # settings of old files -> the modifier to use instead


def of(settings):
    """The Repair in an object's settings; None if it does nothing."""
    orient, resample = settings.repair_orient, settings.repair_resample
    if not orient and not resample:
        return None
    return Repair(orient, resample, settings.repair_edge_length if resample else 0.0)


def remarks_of_removed(obj):
    """Sentences about removed settings that an object still has from a file of an earlier version."""
    stored = obj.original.fovea
    return [
        f"'{obj.name}': {modifier} is not a setting of the object anymore: add the modifier {modifier}"
        for setting, modifier in REMOVED.items()
        if stored.get(setting)
    ]


def removed_attributes():
    """{removed setting: property} for an object's settings; access raises AttributeError with the modifier to use."""

    def refusing(setting, modifier):
        def refuse(_settings, *_value):
            raise AttributeError(f"{setting} is not a setting of objects anymore: add the modifier {modifier}")

        return property(refuse, refuse)

    return {setting: refusing(setting, modifier) for setting, modifier in REMOVED.items()}
