# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws scenes that it reads from a file, and tells what came of it, to the last bit: by which two builds of the
module, or two processors, are compared.

    pictures.py IMPORTABLE    prints digests, by the module in the package `addon` in folder IMPORTABLE, as digests.json
"""

import json
import sys
import tempfile
from pathlib import Path

import numpy as np

STYLES = ("pen_and_ink", "watercolor", "charcoal", "technical")
METHODS = ("exact", "atlas")
SIZE = (320, 240)


def save(path):
    """Writes the scenes' meshes and matrices, so that nothing of them is computed where they are drawn. Their numbers
    are rounded to less than what sines of different systems differ by."""
    from addon import still_life

    eye, clip, near, far = still_life.view()
    clip[0, 0] *= SIZE[1] / SIZE[0]
    arrays = {"eye": np.round(eye, 6), "clip": np.round(clip, 6), "near": near, "far": far}
    for shapes, scene in ((still_life.shapes(), "still_life"), (still_life.boards(), "boards")):
        for i, shape in enumerate(shapes):
            arrays[f"{scene}/{i:02}/positions"] = np.round(np.float64(shape.positions), 4).astype(np.float32)
            for name in ("corners", "offsets"):
                arrays[f"{scene}/{i:02}/{name}"] = getattr(shape, name)
    np.savez(path, **arrays)


def tell(path):
    """Yields (what, digest)."""
    import native_core

    from addon import pipeline, style

    stored = np.load(path)
    seen = native_core.core.View(
        stored["eye"], stored["clip"], *SIZE, False, float(stored["near"]), float(stored["far"])
    )
    for scene in ("still_life", "boards"):
        placed = native_core.scene(list(_surfaces(native_core, stored, scene)))
        yield f"{scene}, all line definitions", native_core.digest(native_core.draw(placed, seen))
        for name in STYLES:
            for method in METHODS:
                options = pipeline.options(visibility=method)
                frame = pipeline.frame(placed, seen, style.load(name), native_core.core.CpuBackend(), options)
                frame.picture()
                yield f"{scene}, {name}, {method}", native_core.digest(native_core.images(frame.passes()))
        yield f"{scene}, comic, in the sun", native_core.digest(_in_the_sun(native_core.core, placed, seen))


def _in_the_sun(core, placed, seen):
    """The picture with blacks and soft shadows."""
    from addon import pipeline, style

    drawn = style.load("comic")
    drawn = drawn.replace(color=drawn.color.replace(shadow=0.5))
    sun = core.Light("sun", (0.0, 0.0, 0.0), (-0.55, -0.35, -0.75), (3.0, 3.0, 3.0), radius=0.1)
    sources = core.ColorSources([None] * len(placed), [sun], (0.25, 0.25, 0.25))
    picture = pipeline.draw(placed, seen, drawn, core.CpuBackend(), pipeline.options(), colors=sources)
    return {"combined": picture.combined}


def _surfaces(native_core, stored, scene):
    for i in sorted({key.split("/")[1] for key in stored if key.startswith(scene + "/")}):
        positions, verts, offsets = (stored[f"{scene}/{i}/{name}"] for name in ("positions", "corners", "offsets"))
        found = native_core.core.PolygonEdges(offsets, verts)
        arrays = {"positions": positions, "edge_verts": found.edge_verts, "corner_verts": verts}
        arrays |= {"corner_edges": found.corner_edges, "polygon_offsets": offsets}
        yield native_core.surface(f"{scene} {i}", arrays)


if __name__ == "__main__":
    sys.path[:0] = [sys.argv[1], str(Path(__file__).parent)]
    with tempfile.TemporaryDirectory() as folder:
        save(Path(folder) / "scenes.npz")
        print(json.dumps(dict(tell(Path(folder) / "scenes.npz")), indent=1))
