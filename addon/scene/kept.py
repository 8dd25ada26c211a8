# SPDX-License-Identifier: GPL-3.0-or-later
"""What is kept between pictures, and the bound that preferences give to it.

Caches of surfaces (with what was found on them: fields, lines, BVHs) and of colors are registered here. When they
hold more than the limit, what was unused longest is let go, until it is enough or only what a snapshot of a scene still
needs is left: what viewports show, what is being drawn. It is made again when it is needed, so that pictures do not
depend on it. What allocates memory for Blender holds on to some of it for what comes next.
"""

import itertools
import weakref
from dataclasses import dataclass

MEGABYTE = 1 << 20

_caches = weakref.WeakSet()
_snapshots = weakref.WeakValueDictionary()  # by their ids
limit = 0  # bytes; 0: none
_times = itertools.count(1)


@dataclass(frozen=True)
class Item:
    """Something that a cache holds."""

    used: int  # when it was last asked for, as `now` says it
    size: int  # bytes, about
    let_go: object  # does that; None: it is still needed


def now():
    """A number that is higher every time."""
    return next(_times)


def set_limit(megabytes):
    """From now on; 0: no limit."""
    global limit
    limit = megabytes * MEGABYTE
    trim()


def add_cache(cache):
    """A cache has `items(needed)`; `needed`: ids of the surfaces that snapshots have."""
    _caches.add(cache)


def add_snapshot(snapshot):
    """Its surfaces are needed as long as it is there."""
    _snapshots[id(snapshot)] = snapshot


def held():
    """The Items of all caches."""
    needed = {id(surface) for snapshot in list(_snapshots.values()) for surface in snapshot.surfaces}
    return [item for cache in list(_caches) for item in cache.items(needed)]


def trim():
    """Lets go of what is beyond the limit."""
    if not limit:
        return
    items = held()
    size = sum(item.size for item in items)
    for item in sorted(items, key=lambda item: item.used):
        if size <= limit:
            return
        if item.let_go:
            item.let_go()
            size -= item.size
