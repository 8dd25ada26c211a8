# SPDX-License-Identifier: GPL-3.0-or-later
"""How large drawings are on paper, as their files or their users say, and lengths there in pixels. Without Blender."""

import re
from dataclasses import dataclass

SIGNATURE = 8  # bytes before the first chunk of a PNG
SCREEN = 71.5, 72.5  # dots per inch that programs write, Blender among them, where there is no paper
INCH = 25.4  # millimeters
LENGTHS = "mm", "cm", "in", "pt", "pc"  # units of an SVG that say how large its page is on paper
APART = 0.01  # share by which sizes may differ that files say of one paper
UNKNOWN = (
    "a tolerance in millimeters needs to know how wide the paper is, and no drawing says it: name its width with "
    "--paper-width, save a PNG with its resolution (a scan has it), or give the tolerance in pixels"
)


@dataclass(frozen=True)
class Millimeters:
    """A length on paper. `paper_width`: that of the frame; None: as the drawings' files say."""

    length: float
    paper_width: float | None = None


def of_png(content, size):
    """The (width, height) [mm] that a PNG file of (width, height) pixels says of its paper; None: it does not."""
    at = SIGNATURE
    while at + 17 <= len(content) and content[at + 4 : at + 8] != b"IDAT":
        data, length = at + 8, int.from_bytes(content[at : at + 4], "big")
        if content[at + 4 : at + 8] == b"pHYs" and length == 9:
            per_meter = [int.from_bytes(content[data + i : data + i + 4], "big") for i in (0, 4)]
            is_paper = content[data + 8] == 1 and min(per_meter) > 0
            is_screen = all(SCREEN[0] < n * INCH / 1000 < SCREEN[1] for n in per_meter)
            return tuple(1000 * side / n for side, n in zip(size, per_meter)) if is_paper and not is_screen else None
        at += length + 12
    return None


def of_svg(root, size):
    """The same of an SVG's root element, whose page has (width, height) in pixels of 1/96 inch."""
    units = [re.sub(r"[\d.eE+\s-]*", "", root.get(name, "")) for name in ("width", "height")]
    return tuple(INCH / 96 * side for side in size) if any(unit in LENGTHS for unit in units) else None


def in_pixels(asked, width, known):
    """What Millimeters are in a frame of `width` pixels. `known`: (name of a drawing, pixels per millimeter or None) of
    each drawing of that frame. ValueError in a sentence where nobody says how large the paper is, or files differ."""
    if asked.paper_width:
        return asked.length * width / asked.paper_width
    told = {name: per_mm for name, per_mm in known if per_mm}
    if not told:
        raise ValueError(UNKNOWN)
    least, most = min(told, key=told.get), max(told, key=told.get)
    if told[most] > (1 + APART) * told[least]:
        sizes = " and ".join(f"{width / told[name]:.0f} mm wide by {name}" for name in (least, most))
        raise ValueError(f"the paper is {sizes}: name its width with --paper-width")
    return asked.length * told[least]
