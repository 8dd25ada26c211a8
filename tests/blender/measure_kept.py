# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how much memory is freed when caches are cleared, compared with their estimated size; in a separate Blender
process, whose heap is not fragmented by other tests: blender -b -P measure_kept.py -- STYLE."""

import ctypes
import gc
import json
import os
import statistics
import sys
import tempfile
from pathlib import Path

sys.path.append(str(Path(__file__).parent))

import numpy as np
from pictures import box_scene, drawn
from the_addon import new_mesh, new_object, part, use_style

kept, native = part("scene.kept"), part("native")


def ball(name, place, around=140):
    """A finely divided sphere."""
    angle = np.linspace(0, 2 * np.pi, around, endpoint=False)
    up = np.linspace(-1, 1, around // 2 + 2)[1:-1]
    rings = np.array([[(np.sqrt(1 - z * z) * np.cos(a), np.sqrt(1 - z * z) * np.sin(a), z) for a in angle] for z in up])
    i, j = np.meshgrid(np.arange(len(up) - 1), np.arange(around), indexing="ij")
    a, b = i * around + j, i * around + (j + 1) % around
    quads = np.stack([a, b, b + around, a + around], axis=-1).reshape(-1, 4)
    return new_object(new_mesh(rings.reshape(-1, 3).tolist(), [], quads.tolist(), name), name, place)


def megabytes():
    """That are reckoned to be kept."""
    return sum(item.size for item in kept.held()) / kept.MEGABYTE


def settled():
    """MB that this process has once its allocators have given back what they can: Blender's on Linux is that of TBB."""
    gc.collect()
    native.load().release_memory()
    ctypes.CDLL("libtbbmalloc.so.2").scalable_allocation_command(0, None)
    ctypes.CDLL("libc.so.6").malloc_trim(0)
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / kept.MEGABYTE


def main(style):
    """Prints the median of three: allocators keep now more and now less, and give back later what they kept before."""
    scene = box_scene()
    use_style(scene, style)
    for i in range(3):
        ball(f"Ball {i}", (2.0 * i - 2, 0, 0), 500)
    back = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(4):
            kept.set_limit(0)
            drawn(scene, Path(folder) / "a.png")
            reckoned, before = megabytes(), settled()
            kept.set_limit(1)
            back.append(before - settled())
    # What is loaded once is loaded after the first.
    print("MEASURED", json.dumps({"reckoned": reckoned, "back": statistics.median(back[1:])}))


if __name__ == "__main__":
    main(sys.argv[sys.argv.index("--") + 1])
