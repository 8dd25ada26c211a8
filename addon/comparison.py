# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings of files as sets of pixels, and how near they are to each other. Without Blender.

A drawing is a PNG (a scan, or a picture by any program), an SVG, or an NPZ of `fovea lines --visible`."""

import hashlib
import zipfile
import zlib
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path

import numpy as np

from . import native, paper_scale, registered_drawing, svg_drawing
from .paper_scale import Millimeters

LINES_SIZE = 1024, 1024  # of an NPZ that does not say it: what `fovea lines` takes
USUAL_DIAGONAL = 1280  # pixels, of 1024 x 768: of drawings that have any size
OTHER_TOLERANCES = 0.5, 2.0  # times the tolerance, that results are told for, too: rankings should not depend on it
FARTHEST, DISTANCES = 4, 41  # of histograms: in tolerances, and how many distances
HEADLINE = "precision", "recall", "f1", "chamfer_px", "iou"


@dataclass(frozen=True)
class Drawing:
    """A file that is read. `bitmap(size)`: its native Bitmap of (width, height) pixels."""

    name: str
    size: tuple | None  # (width, height) in pixels; None: any
    bitmap: object
    shape: tuple = ()  # width and height of one that has any size
    gray: object = None  # native GrayImage of a scan or picture
    millimeters: tuple | None = None  # width and height on paper, where the file says it

    def px_per_mm(self, size):
        """Of a frame of (width, height) pixels that it fills; None: it does not say how large it is."""
        return float(min(np.array(size) / self.millimeters)) if self.millimeters else None


@dataclass(frozen=True)
class Compared:
    """A drawing and those it is judged by, as native Bitmaps, and what `compare` finds."""

    names: tuple
    a: object
    judges: list
    found: dict


def read(path):
    """The Drawing of a file. ValueError, or an OSError, in a sentence if it is none."""
    path = Path(path)
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise ValueError(f"{path.name} is no drawing that can be compared: name a {', '.join(READERS)} file")
    try:
        return reader(path)
    except ValueError as error:
        raise ValueError(f"{path.name}: {error}") from error


def of_png(path):
    content = path.read_bytes()
    gray = native.load().GrayImage.of_png(content)
    size = gray.values.shape[::-1]
    return Drawing(
        path.stem, size, lambda _size: gray.lines(), gray=gray, millimeters=paper_scale.of_png(content, size)
    )


def of_npz(path):
    """Lines in pixels; what is hidden, or left out by line thinning, is not drawn."""
    try:
        with zipfile.ZipFile(path), np.load(path, allow_pickle=False) as file:
            lines = dict(file)
    except (zipfile.BadZipFile, zlib.error) as error:
        raise ValueError("it is not whole: write it again by `fovea lines --visible`") from error
    if not {"px", "offsets", "invisibility", "shown"} <= lines.keys():
        raise ValueError("it has no lines in pixels: write it by `fovea lines --visible`")
    return of_lines(path.stem, lines, tuple(map(int, lines.get("size", LINES_SIZE))))


def of_lines(name, lines, size):
    """The same of the arrays of line_arrays.seen, in a frame of (width, height) pixels."""
    drawn = (lines["invisibility"] == 0) & (lines["shown"] > 0)
    lengths = np.diff(lines["offsets"])
    px, offsets = lines["px"][np.repeat(drawn, lengths)], np.concatenate([[0], np.cumsum(lengths[drawn])])
    return Drawing(name, size, lambda _size: native.load().Bitmap.of_lines(px, offsets, *size))


def of_svg(path):
    found = svg_drawing.read(path.read_bytes())

    def bitmap(size):
        # As large as fits, in the middle.
        scale = min(np.array(size) / found.size)
        transforms = scale * found.transforms
        transforms[:, 4:] += (np.array(size) - scale * np.array(found.size)) / 2
        return native.load().Bitmap.of_svg(found.data, transforms, found.is_filled, *size)

    return Drawing(path.stem, None, bitmap, found.size, millimeters=found.millimeters)


READERS = {".png": of_png, ".svg": of_svg, ".npz": of_npz}


def title(path):
    """What a prompt sheet is called: the name of its picture, and digits by which no other one is mistaken for it."""
    return f"{path.stem} {hashlib.sha256(path.read_bytes()).hexdigest()[:12]}"


def of_drawings(drawings, tolerance=None, register=None):
    """The Compared of Drawings: the first is judged by the others. `tolerance`: [px], Millimeters, or None: the usual
    one. `register`: how pictures among those are registered to the first, one of
    registered_drawing.REGISTERED. ValueError in a sentence
    where that is not possible."""
    on_paper = isinstance(tolerance, Millimeters)
    if register:
        a = _bitmaps(drawings[:1])[0]
        size, near = a.pixels.shape[::-1], None if on_paper else tolerance
        laid = [registered_drawing.laid(drawing, a, register, near) for drawing in drawings[1:]]
        judges, scales = [each.bitmap for each in laid], [each.px_per_mm for each in laid]
    else:
        a, *judges = _bitmaps(drawings)
        size = a.pixels.shape[::-1]
        scales = [drawing.px_per_mm(size) for drawing in drawings[1:]]
    names = tuple(drawing.name for drawing in drawings)
    if not on_paper:
        return Compared(names, a, judges, compare(a, judges, tolerance))
    near = paper_scale.in_pixels(tolerance, size[0], zip(names, (drawings[0].px_per_mm(size), *scales)))
    return Compared(names, a, judges, compare(a, judges, near) | {"tolerance_mm": tolerance.length})


def tolerance_in(drawings, size, register, tolerance):
    """A tolerance in pixels of a frame of (width, height), of what `of_drawings` takes, as Drawings in that frame say;
    those that are registered say nothing of it."""
    if not isinstance(tolerance, Millimeters):
        return tolerance
    known = [(drawing.name, None if register else drawing.px_per_mm(size)) for drawing in drawings]
    return paper_scale.in_pixels(tolerance, size[0], known)


def frame_for(drawings, frame, register=None):
    """The (width, height) of a frame that Drawings are compared in: their own, or that of the scene, `frame`, where
    they have none or are registered. ValueError if their sizes differ."""
    return frame if register else _size_of(drawings) or frame


def judges_of(drawings, size, register=None, tolerance=None):
    """A function of reference(), a Bitmap of (width, height) pixels, that gives a registered_drawing.Laid of each
    Drawing over it: registered to it by one of REGISTERED, or, without it, as it is."""

    def judges(reference):
        if not register:
            return [registered_drawing.Laid(drawing.bitmap(size), drawing.gray) for drawing in drawings]
        over = reference()
        return [registered_drawing.laid(drawing, over, register, tolerance) for drawing in drawings]

    return judges


def registered_png(path, reference, register, tolerance=None):
    """(bytes of a PNG file of a scan, registered by one of REGISTERED to a Bitmap, and of its size; its
    registered_drawing.Laid). Colors stay, but on a prompt sheet, whose print is left out. ValueError in a sentence if
    the file is no picture, or cannot be registered."""
    drawing, core = read(path), native.load()
    if drawing.gray is None:
        raise ValueError(f"{path.name} is no scan: a PNG is registered; what has lines of its own fits as it is")
    found = registered_drawing.laid(drawing, reference, register, tolerance)
    if register == "marks":
        return core.png_bytes(np.repeat(found.gray.values[..., None], 3, axis=2)), found
    size = reference.pixels.shape[::-1]
    channels = np.moveaxis(core.pixels_of_png(path.read_bytes()), 2, 0)
    moved = [core.GrayImage(np.ascontiguousarray(c)).resampled(found.to_scan, *size).values for c in channels]
    return core.png_bytes(np.stack(moved, axis=2)), found


def _size_of(drawings):
    """The (width, height) that all Drawings have; None if none has one. ValueError if their sizes differ."""
    sizes = {drawing.size: drawing.name for drawing in drawings if drawing.size}
    if len(sizes) > 1:
        told = " and ".join(f"{name} has {width} x {height} pixels" for (width, height), name in sizes.items())
        raise ValueError(f"{told}: draw them as large as each other, or register a scan with --register")
    return next(iter(sizes), None)


def _bitmaps(drawings):
    """The native Bitmaps of Drawings, all of one size. ValueError if their sizes differ."""
    size = _size_of(drawings) or _usual_size(drawings[0].shape)
    return [drawing.bitmap(size) for drawing in drawings]


def _usual_size(shape):
    """The (width, height) of a shape with the diagonal of the drawings of the thesis."""
    scale = USUAL_DIAGONAL / np.hypot(*shape)
    return tuple(max(1, round(scale * side)) for side in shape)


def compare(a, judges, tolerance=None):
    """A dict of how near Bitmap a is to each of the Bitmaps `judges`: the measures of HEADLINE, means of all of them;
    tolerance_px (usual where None is given); judged_by: all measures for each; at_tolerances: those of HEADLINE at
    OTHER_TOLERANCES; agreement: shares of pixels within distances, between all judges, or of a and one."""
    tolerance = a.usual_tolerance if tolerance is None else tolerance
    nearness = [native.load().Nearness(a, judge) for judge in judges]
    found = [each.measures(tolerance) for each in nearness]
    others = {factor: [each.measures(factor * tolerance) for each in nearness] for factor in OTHER_TOLERANCES}
    at_tolerances = [{"tolerance_px": factor * tolerance, **_mean(each)} for factor, each in others.items()]
    beside = {"tolerance_px": tolerance, "judged_by": found, "at_tolerances": at_tolerances}
    if len(judges) > 1:
        of, nearness = "All pairs of judges", [native.load().Nearness(*pair) for pair in combinations(judges, 2)]
    else:
        of = "Both drawings"
    return _mean(found) | beside | {"agreement": {"of": of, **_agreement(nearness, tolerance)}}


def _mean(found):
    return {name: float(np.mean([measures[name] for measures in found])) for name in HEADLINE}


def _agreement(nearness, tolerance):
    """Distances [px] of the pixels of drawings from each other, of pairs of them by their native Nearness, as shares of
    all pixels within them."""
    distances = np.linspace(0, FARTHEST * max(tolerance, 1.0), DISTANCES).tolist()
    shares, pixels = [pair.shares_within(distances) for pair in nearness], [pair.pixels for pair in nearness]
    shares = np.average(shares, axis=0, weights=pixels) if any(pixels) else np.ones(DISTANCES)
    return {"distances_px": distances, "shares": shares.tolist()}
