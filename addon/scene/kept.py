# SPDX-License-Identifier: GPL-3.0-or-later
"""The memory limit of the caches between pictures, which the preferences set.

Caches of surfaces (with their fields, lines and BVHs) and of colors are registered here. Above the limit, items are
evicted in the order of their last use, until the total is below it or all items left are pinned by a living Snapshot:
one that a viewport shows or that is being drawn. Evicted items are built again on demand, so pictures do not depend on
the limit. The process's memory may shrink by less, because the allocator keeps freed pages.
"""

import itertools
import weakref
from dataclasses import dataclass

MEGABYTE = 1 << 20

_caches = weakref.WeakKeyDictionary()  # cache -> release_memory of its native module
_snapshots = weakref.WeakValueDictionary()  # id -> living Snapshot
limit = 0  # bytes; 0: no limit
_times = itertools.count(1)


@dataclass(frozen=True)
class Item:
    """An entry of a cache."""

    used: int  # time of its last use, from `now`
    size: int  # bytes, estimated
    let_go: object  # function that evicts it; None: it is pinned


def now():
    """Logical time: a counter that increases with each call."""
    return next(_times)


def set_limit(megabytes):
    """Sets the limit (0: none) and trims."""
    global limit
    limit = megabytes * MEGABYTE
    trim()


def add_cache(cache, core):
    """Registers a cache (weakly) of objects of `core`, the native module. It has a method items(needed) -> Items;
    `needed`: ids of surfaces in living Snapshots."""
    _caches[cache] = core.release_memory


def add_snapshot(snapshot):
    """Pins a Snapshot's surfaces while it is alive."""
    _snapshots[id(snapshot)] = snapshot


def held():
    """The Items of all caches."""
    needed = {id(surface) for snapshot in list(_snapshots.values()) for surface in snapshot.surfaces}
    return [item for cache in list(_caches) for item in cache.items(needed)]


def trim():
    """Evicts items, least recently used first, until the total is within the limit."""
    if not limit:
        return
    items = held()
    size = sum(item.size for item in items)
    if size <= limit:
        return
    for item in sorted(items, key=lambda item: item.used):
        if size > limit and item.let_go:
            item.let_go()
            size -= item.size
    for release in set(_caches.values()):
        release()  # that arrays of what was evicted have left to it
