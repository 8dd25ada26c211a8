# SPDX-License-Identifier: GPL-3.0-or-later
"""Final renders as vectors: the strokes of a picture as curves in files."""

from functools import partial

from .. import files, native, pipeline
from . import as_rendered, session


def options(**given):
    """Native VectorOptions; those not given have their defaults."""
    return native.load().VectorOptions(**given)


def choices(of):
    """(name, label, description) of what an option can be: of `VECTORS`, the kinds of files, `SHEETS` or `WIDTHS`."""
    return [] if native.problem() else getattr(native.load(), of)


_kept = {}  # Blender does not keep items of functions alive


def kept_items(of):
    """The same as a list that stays alive, empty as long as the native module is not there."""
    if not _kept.get(of):
        _kept[of] = list(choices(of))
    return _kept[of]


def sheet_sizes():
    """{sheet of paper: (width, height) in millimeters, upright}."""
    known = ((name, native.load().sheet_size(name)) for name, *_ in kept_items("SHEETS"))
    return {name: size for name, size in known if any(size)}


def drawing(context, kind, asked, **how):
    """The native Drawing, for files of a kind (svg, pdf, dxf), of a final render of the context's frame and view layer
    with VectorOptions, or None if the user canceled it; `how` as for `session.final`."""
    make = partial(_drawing, kind=kind, asked=asked)
    found = as_rendered.look(context, partial(session.final, make=make, **how))
    return found and found[1]


def write(drawn, path):
    """Writes a Drawing to a file, which is whole or not there."""
    content = drawn.file()
    with files.written(path) as fresh:
        fresh.write_bytes(content)


def _drawing(found, *given, kind, asked):
    """`given`: what `session.draw` is given after what is read."""
    *shown, progress, cancel, near = given
    beside = {"colors": found.colors, "notes": found.notes, "near": near, "progress": progress, "cancel": cancel}
    frame = pipeline.frame(found.placed, *shown, **beside)
    with native.refusals():
        return native.load().Drawing(frame, asked, kind)
