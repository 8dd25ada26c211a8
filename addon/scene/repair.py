# SPDX-License-Identifier: GPL-3.0-or-later
"""What of an object's mesh is put in order before it is drawn: what no modifier of Blender's does."""

from dataclasses import asdict, dataclass


@dataclass(frozen=True)
class Repair:
    """native/fovea/repair/repair.h; everything off."""

    orient: bool = False
    resample: int = 0
    edge_length: float = 0.0

    def words(self):
        """As the native module takes them."""
        return asdict(self)


NOTHING = Repair()
REMARKS = {  # what a RepairReport counts
    "turned_polygons": "faces were turned around",
    "refused_polygons": "faces are not manifold and were left as they are",
}
REMOVED = {"repair_weld": "Weld", "repair_smooth": "Smooth"}  # settings of old files -> the modifier to use instead


def of(obj, depsgraph):
    """The Repair that the user wants for an instance's object, or None."""
    settings = obj.original.evaluated_get(depsgraph).fovea
    length = settings.repair_edge_length if settings.repair_resample else 0.0
    wanted = Repair(settings.repair_orient, settings.repair_resample, length)
    return None if wanted == NOTHING else wanted


def remarks_of_removed(obj):
    """Sentences about settings that an object has from a file of an earlier version, and that are not there anymore."""
    stored = obj.original.fovea
    return [
        f"'{obj.name}': {modifier} is not a setting of the object anymore: add the modifier {modifier}"
        for setting, modifier in REMOVED.items()
        if stored.get(setting)
    ]


def removed_attributes():
    """Attributes of an object's settings, by name, that tell a script which modifier to use instead."""

    def refusing(setting, modifier):
        def refuse(_settings, *_value):
            raise AttributeError(f"{setting} is not a setting of objects anymore: add the modifier {modifier}")

        return property(refuse, refuse)

    return {setting: refusing(setting, modifier) for setting, modifier in REMOVED.items()}
