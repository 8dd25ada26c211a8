# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea draw --dump`: what a final render is drawn from, as arrays in one file, for bug reports.

The arrays have the names of the native Frame's members (native/fovea/draw/frame.h, native/bindings), dotted:
`clipped.px`, `runs.start_px`. What the frame has not, as `shown` without elision, is not in the file."""

import zipfile

import bpy
import numpy as np
from bl_ext.user_default.fovea import native, pipeline, style
from bl_ext.user_default.fovea.render import as_rendered, session
from bl_ext.user_default.fovea.scene import camera
from command import output

# In the order in which a Frame fills them. Not its scene and textures, which are large, and not its pens: their numbers
# are those of `style`, and `strokes.pen` counts them as Style.pens() does.
MEMBERS = (
    "view",
    "options",
    "paths",
    "clipped",
    "visible",
    "samples",
    "runs",
    "focus",
    "distance",
    "shown",
    "drawn",
    "strokes",
    "stages",
    "visibility_in_words",
)


def write(context, path):
    """Writes the frame of the context's view layer to `path`, an .npz that numpy.load reads without pickle."""
    arrays = as_rendered.look(context, frame_of_render)
    with output.written(path, zipfile.is_zipfile) as fresh:
        np.savez_compressed(fresh, **arrays)


def frame_of_render(engine, depsgraph):
    """The arrays of what a final render of the depsgraph's scene is drawn from. Its projection is not the Frame's to tell."""
    _, arrays, _ = session.final(engine, depsgraph, frame_arrays)
    return arrays | {"view.view_to_clip": camera.of_render(engine, depsgraph).view_to_clip}


def frame_arrays(found, seen, chosen, backend, options, progress, cancel, near):
    """{dotted name: array} of what session.draw would make a picture of, up to its strokes."""
    beside = {"colors": found.colors, "notes": found.notes, "near": near}
    frame = pipeline.frame(found.placed, seen, chosen, backend, options, **beside, progress=progress, cancel=cancel)
    frame.ink()
    whole = {name: getattr(frame, name) for name in MEMBERS}
    whole |= {"style": style.dump(chosen), "backend": backend.name, "objects": list(found.snapshot.objects)}
    whole |= {"blender": bpy.app.version_string, "ingest_ms": 1000 * found.seconds}
    return dict(flat(whole))


def flat(members, name=""):
    """(dotted name, array) pairs of a value: of arrays, plain values and lists of them the value itself, of what has
    members theirs, of None none."""
    if members is None:
        return
    if isinstance(members, (np.ndarray, str, bool, int, float, list, tuple)):
        yield name, np.asarray(members)
    else:
        for inner, value in _named(members):
            yield from flat(value, f"{name}.{inner}" if name else inner)


def _named(members):
    """(name, value) pairs of a dict or of a native object's properties."""
    if isinstance(members, dict):
        return members.items()
    kind = type(members)
    if kind.__module__ != native.load().__name__:
        raise TypeError(f"a frame's members are arrays, plain values and native objects, not {kind.__name__}")
    return ((of, getattr(members, of)) for of in dir(kind) if isinstance(getattr(kind, of), property))
