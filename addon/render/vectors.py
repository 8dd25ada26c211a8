# SPDX-License-Identifier: GPL-3.0-or-later
"""Final renders as vectors: the strokes of a picture as curves in files."""

from functools import partial

from .. import files, native, pipeline
from . import as_rendered, session

SUFFIXES = (".svg",)


def options(**given):
    """Native VectorOptions; those not given have their defaults."""
    return native.load().VectorOptions(**given)


def drawing(context, asked, **how):
    """The native Drawing of a final render of the context's frame and view layer with VectorOptions, or None if the
    user canceled it; `how` as for `session.final`."""
    make = partial(_drawing, asked=asked)
    found = as_rendered.look(context, partial(session.final, make=make, **how))
    return found and found[1]


def write(drawn, path):
    """Writes a Drawing to a file, whose suffix says of what kind it is."""
    text = getattr(drawn, path.suffix[1:])()
    with files.written(path) as fresh:
        fresh.write_bytes(text)


def _drawing(found, seen, chosen, backend, asked_of_frame, progress, cancel, near, asked):
    beside = {"colors": found.colors, "notes": found.notes, "near": near, "progress": progress, "cancel": cancel}
    frame = pipeline.frame(found.placed, seen, chosen, backend, asked_of_frame, **beside)
    with native.refusals():
        return native.load().Drawing(frame, asked)
