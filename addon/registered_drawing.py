# SPDX-License-Identifier: GPL-3.0-or-later
"""Scans of drawings brought to where a picture has the same lines: by these, or by the marks of a prompt sheet. Without
Blender."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

LEAST_OUTER = 0.9  # share of the outer boundary that a registered drawing has a line near to
DARKEST_PRINT = 0.75  # of the paper: what is brighter is the faint picture of a prompt sheet
BOX = 0.005  # of the longer side, along the border: the box of a prompt sheet


@dataclass(frozen=True)
class Laid:
    """A Drawing over a reference. `gray`: a native GrayImage of the reference's pixels, None of what is no picture."""

    bitmap: object
    gray: object = None
    px_per_mm: float | None = None  # of the reference's pixels on the drawing's paper
    to_scan: object = None  # (3, 3) from the reference's pixels to those of the drawing, where it was registered
    scan: object = None  # native GrayImage of the drawing as it was scanned, where it was

    @cached_property
    def stroke_looks(self):
        """((N,) numbers of the reference's pixels, (N, 3) widths in these, as they are measured, and darkness) of a
        picture's strokes. Of a scan they are measured there: resampling blurs narrow ones."""
        if self.scan is None:
            looks = self.gray.stroke_looks(self.bitmap)
            return looks.pixel, np.stack([looks.width, looks.width, looks.darkness], axis=1)
        looks, (height, width) = self.scan.stroke_looks(self.scan.lines()), self.bitmap.pixels.shape
        y, x = np.divmod(looks.pixel, self.scan.values.shape[1])
        at = np.linalg.inv(self.to_scan) @ np.stack([x + 0.5, y + 0.5, np.ones(len(x))])
        x, y = np.floor(at[:2] / at[2]).astype(np.int64)
        inside = (x >= 0) & (y >= 0) & (x < width) & (y < height)
        of_frame = looks.width / _growth(self.to_scan, (width, height))
        return (y * width + x)[inside], np.stack([of_frame, looks.width, looks.darkness], axis=1)[inside]


def laid(drawing, reference, register, tolerance=None):
    """The Laid of a Drawing that is registered to a Bitmap by one of REGISTERED; what is no picture fits as it is."""
    size = reference.pixels.shape[::-1]
    if drawing.gray is None:
        return Laid(drawing.bitmap(size), px_per_mm=drawing.px_per_mm(size))
    to_scan, on_sheet = REGISTERED[register](
        drawing, reference, reference.usual_tolerance if tolerance is None else tolerance
    )
    gray, scan, of_scan = drawing.gray.resampled(to_scan, *size), drawing.gray, drawing.px_per_mm(drawing.size)
    if on_sheet:
        gray, scan = _drawn_on_sheet(gray), _without_print(scan)
    return Laid(gray.lines(), gray, of_scan and of_scan / _growth(to_scan, size), to_scan, scan)


def _growth(to_scan, size):
    """Pixels of the scan per pixel of the reference, in the middle of it."""
    (x, y), step = np.array(size) / 2, 0.5
    corners = to_scan @ np.array([(x + dx, y + dy, 1) for dx, dy in ((-step, 0), (step, 0), (0, -step), (0, step))]).T
    left, right, low, high = (corners[:2] / corners[2]).T
    return float(np.sqrt(abs(np.linalg.det([right - left, high - low]))))


def _by_lines(drawing, reference, tolerance):
    """(the matrix from a Bitmap's pixels to those of a Drawing by its lines, whether it is drawn on a prompt sheet)."""
    found = drawing.gray.lines().registration(reference, tolerance)
    share = found["outer_share"] if found else 0.0
    if share < LEAST_OUTER:
        raise ValueError(
            f"{drawing.name} could not be registered: {share:.0%} of the outer boundary have a line within the "
            f"tolerance, and {LEAST_OUTER:.0%} are needed; use a prompt sheet, or a larger --tolerance"
        )
    return found["to_scan"], False


def _by_marks(drawing, reference, _tolerance):
    """The same by the marks of a prompt sheet."""
    to_scan = drawing.gray.frame_by_marks(*reference.pixels.shape[::-1])
    if to_scan is None:
        raise ValueError(
            f"{drawing.name}: the marks of a prompt sheet are not found: scan all five discs around the frame, or "
            "register it by its lines"
        )
    return to_scan, True


def _without_print(gray):
    """A native GrayImage without the faint picture that a prompt sheet has printed."""
    values = gray.values.copy()
    paper = np.median(values)
    values[values >= DARKEST_PRINT * paper] = paper
    return type(gray)(values)


def _drawn_on_sheet(gray):
    """A native GrayImage of a sheet's frame without the faint picture and the box along the border."""
    values = _without_print(gray).values
    border = int(np.ceil(BOX * max(values.shape)))
    return type(gray)(np.pad(values[border:-border, border:-border], border, constant_values=int(np.median(values))))


REGISTERED = {"lines": _by_lines, "marks": _by_marks}
