# SPDX-License-Identifier: GPL-3.0-or-later
"""Thumbnails of styles: renders of fixed small scenes (still_life.py) by the native module. They use no Blender data,
so they do not depend on the open file."""

from functools import lru_cache

import numpy as np

from .. import native, pipeline, still_life, style
from ..scene import scene
from ..stages import View

SIZE = 256  # pixels along each side
OVERSIZE = 2  # supersampling factor along each axis
HEIGHT = 480.0  # height of the thumbnail in reference pixels; sets the size of pens


def draw(drawn, shapes=still_life.shapes):
    """The thumbnail of a Style: (SIZE, SIZE, 3) uint8 sRGB, bottom row first. `shapes`: the function of still_life that
    makes the scene. native.Unavailable without the native module."""
    core = native.load()
    placed, sources = scene_of(shapes)
    world_to_view, clip, near, far = still_life.view()
    size = OVERSIZE * SIZE
    seen = scene.seen(core, View(world_to_view, clip, size, size, False, near, far, size / HEIGHT))
    chosen = drawn.replace(focus=_look(), paper=drawn.paper.replace(transparent=False))
    image = pipeline.draw(placed, seen, chosen, core.CpuBackend(), pipeline.options(), colors=sources).combined
    small = image[..., :3].reshape(SIZE, OVERSIZE, SIZE, OVERSIZE, 3).mean(axis=(1, 3))
    return np.round(255 * _encoded(np.clip(small, 0, 1))).astype(np.uint8)


def png(pixels):
    """The bytes of a PNG file of (H, W, 3) uint8, bottom row first."""
    return native.load().png_bytes(pixels)


def _look():
    """The Focus of thumbnails, chosen so that effects of focus are visible."""
    return style.Focus(model="image", points=(style.FocusPlace(at=(0.4, 0.45, 0.0), near=0.1, far=0.75),))


@lru_cache(maxsize=2)
def scene_of(shapes):
    """(native Scene, native ColorSources) of the shapes that a function of still_life makes."""
    core = native.load()
    surfaces, colors = [], []
    for shape in shapes():
        edges = core.PolygonEdges(shape.offsets, shape.corners)
        mesh = core.Mesh(
            positions=shape.positions,
            edge_verts=edges.edge_verts,
            corner_verts=shape.corners,
            corner_edges=edges.corner_edges,
            polygon_offsets=shape.offsets,
        )
        surfaces.append(core.Surface(shape.name, mesh))
        colors.append(core.SurfaceColor([core.ColorSlot(shape.color)], shape.normals))
    count = len(surfaces)
    usage = np.full(count, scene.DRAW | scene.OCCLUDE, np.uint8)
    places = np.tile(np.eye(4), (count, 1, 1))
    ids = np.arange(1, count + 1, dtype=np.uint64)
    placed = core.Scene(surfaces, np.arange(count, dtype=np.int32), places, ids, usage)
    sun = core.Light("sun", (0.0, 0.0, 0.0), still_life.SUN, (3.0, 3.0, 3.0))
    return placed, core.ColorSources(colors, [sun], (0.25, 0.25, 0.25))


def _encoded(linear):
    """Linear to sRGB encoding."""
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
