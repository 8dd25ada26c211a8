# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea draw --dump`: saves the intermediate arrays of a final render in one file, for bug
reports.

The arrays are named after the native Frame's members (native/fovea/draw/frame.h, native/bindings), dotted:
`clipped.px`, `runs.start_px`. Members that are empty, such as `shown` without elision, are not in the file."""

import zipfile

import bpy
import numpy as np
from bl_ext.user_default.fovea import native, pipeline, style
from bl_ext.user_default.fovea.render import as_rendered, session
from bl_ext.user_default.fovea.scene import camera
from command import output

# In the order in which a Frame fills them. Omitted are its scene and textures, which are large, and its pens: they are
# in `style`, and `strokes.pen` are indices into Style.pens().
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
    """{name: array} for a final render of the depsgraph's scene; view_to_clip is added, which the Frame does not
    expose."""
    _, arrays, _ = session.final(engine, depsgraph, frame_arrays)
    return arrays | {"view.view_to_clip": camera.of_render(engine, depsgraph).view_to_clip}


def frame_arrays(found, seen, chosen, backend, options, progress, cancel, near):
    """{dotted name: array} of the Frame that session.draw would render, up to its strokes; arguments as there."""
    beside = {"colors": found.colors, "notes": found.notes, "near": near}
    frame = pipeline.frame(found.placed, seen, chosen, backend, options, **beside, progress=progress, cancel=cancel)
    frame.ink()
    whole = {name: getattr(frame, name) for name in MEMBERS}
    whole |= {"style": style.dump(chosen), "backend": backend.name, "objects": list(found.snapshot.objects)}
    whole |= {"blender": bpy.app.version_string, "ingest_ms": 1000 * found.seconds}
    return dict(flat(whole))


def flat(members, name=""):
    """Yields (dotted name, array) for a value: itself if it is an array, plain value or list of these; recursively its
    members if it is a dict or native object; nothing for None."""
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
