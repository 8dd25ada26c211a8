# SPDX-License-Identifier: GPL-3.0-or-later
"""Match Line Art: whether objects have lines and hide those behind them, as Line Art's usages of objects and
collections say."""

# Line Art's usage -> Fovea's.
USAGES = {"EXCLUDE": "IGNORE", "OCCLUSION_ONLY": "OCCLUDE", "INCLUDE": "BOTH"}
# Line Art's usage that Fovea's does not have -> what it says.
UNMATCHED = {
    "INTERSECTION_ONLY": "intersection lines alone",
    "NO_INTERSECTION": "no intersection lines",
    "FORCE_INTERSECTION": "intersection lines with objects that have none",
}
LINKED = "its usage: it is linked from another file, where it can be set"
OWN_CREASES = "a crease angle of its own"
_NAMED = 3  # most objects listed by name for the same reason


def usages(scene):
    """({object: Fovea's usage}, sentences about usages that could not be converted) of a scene's objects. Objects of
    which Line Art says nothing are not among them."""
    found, left = {}, {}
    for obj in scene.objects:
        usage = _usage(scene.collection, obj)
        if obj.lineart.use_crease_override:
            left.setdefault(OWN_CREASES, []).append(obj.name)
        if usage in UNMATCHED:
            left.setdefault(UNMATCHED[usage], []).append(obj.name)
        elif usage and obj.library:
            left.setdefault(LINKED, []).append(obj.name)
        elif usage:
            found[obj] = USAGES[usage]
    return found, [f"{_listed(names)}: {what}" for what, names in left.items()]


def _usage(collection, obj):
    """Line Art's usage of an object: its own or, as Line Art has it, that of the first collection below this one that
    it is in and that says one, whatever those above say; None: nothing is said."""
    if obj.lineart.usage != "INHERIT":
        return obj.lineart.usage
    if obj.name in collection.objects and collection.objects[obj.name] == obj:
        return None if collection.lineart_usage == "INCLUDE" else collection.lineart_usage
    return next(filter(None, (_usage(child, obj) for child in collection.children)), None)


def _listed(names):
    more = f" and {len(names) - _NAMED} more" if len(names) > _NAMED else ""
    return ", ".join(f"'{name}'" for name in names[:_NAMED]) + more
