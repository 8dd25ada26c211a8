# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea bench coherence`: how steady lines are from frame to frame, beside Freestyle and Line Art.

One process per scene and renderer; runs in plain Python. All lines but hatching, which has no peers, are dashes of
PERIOD pixels, whose coordinate along the line is what slides or holds still. Freestyle and Line Art begin it anew at
each stroke's start.

The same measures, on the same grounds (measures.py), for all: points of a frame's strokes are moved with the scene to
the next frame, and found on the strokes there. window: frames to each side that visibility answers to. pure:
whether frames drawn backwards, in another order and alone in a new scene are equal. changes_per_frame: mean change of
the number of strokes. unexplained_per_frame: what of it happens where the number of whole lines, seen or not, changes,
too, so that visibility alone does not explain it; of Fovea, as others do not tell. slide: how far dashes move along a
moving point's line, at most half a period, in pixels. stretch: |log2| of a dash's length on paper over the wanted one.
blinks_per_1000: strokes that live for at most two frames, of 1000 strokes. popping: mean change of ink at points that
move with the scene. frame_s: seconds a frame."""

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path

from .. import peers

WORKER = Path(__file__).with_name("worker.py")
SCENES = ("orbit", "turntable", "dolly", "zoom", "walk")  # motions.py
RENDERERS = ("fovea", "freestyle", "line_art")


@dataclass(frozen=True)
class Lines:
    """Lines that are measured together."""

    kinds: tuple  # definitions
    of_view: bool  # else fixed to the mesh
    dashed: bool = True
    usual: bool = True  # measured where none are named
    renderers: tuple = RENDERERS  # that have them


LINES = {
    "mesh": Lines(("crease", "border"), of_view=False),
    "view": Lines(("contour",), of_view=True),
    "smooth": Lines(("smooth_contour",), of_view=True, usual=False, renderers=("fovea", "freestyle")),
    # Spaced evenly on paper, without marks to hand on.
    "hatching": Lines(("hatching",), of_view=False, dashed=False, usual=False, renderers=("fovea",)),
}
ANCHORS = ("screen", "path")
FRAMES, QUICK_FRAMES = 16, 4
MARKS, BAKED = 16, "baked"  # frames
PERIOD = 18  # pixels of a dash and its gap
MEASURES = (
    "pure", "changes_per_frame", "unexplained_per_frame", "slide_median_px", "slide_p95_px", "stretch_median",
    "stretch_p95", "blinks_per_1000", "popping", "frame_s",
)  # fmt: skip
COLUMNS = ("scene", "renderer", "lines", "window", "marks", *MEASURES)


def parse(words):
    parser = argparse.ArgumentParser("fovea bench coherence", description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("--scenes", type=peers.some_of(SCENES), default=list(SCENES), metavar="A,B", help=", ".join(SCENES))
    add("--renderers", type=peers.some_of(RENDERERS), default=list(RENDERERS), metavar="A,B", help="of all three")
    described = (
        "mesh: creases; view: contours; smooth: smooth contours, not of Line Art; hatching: of planes of the objects, "
        "without dashes, of Fovea (mesh,view)"
    )
    usual = [name for name, lines in LINES.items() if lines.usual]
    add("--lines", type=peers.some_of(LINES), default=usual, metavar="A,B", help=described)
    add("--anchor", choices=ANCHORS, default="path", help="what Fovea's dashes are fixed to (path)")
    window = "frames to each side that visibility in Fovea answers to (0)"
    add("--window", type=frames_to_each_side, default=0, metavar="N", help=window)
    marks = (
        f"frames over which Fovea hands marks on lines of the view on ({MARKS}); 0: it does not; {BAKED}: through all"
    )
    add("--marks", type=frames_or_baked, default=MARKS, metavar=f"N|{BAKED}", help=marks)
    add("--size", type=peers.frame_size, metavar="WxH", help="of the picture (960x540)")
    add("--frames", type=peers.count, metavar="N", help=f"of each scene, at least 2 ({FRAMES})")
    add("--pictures", type=Path, metavar="FOLDER", help="for strips of frames, and one row of pixels over time")
    add("--quick", action="store_true", help=f"{QUICK_FRAMES} frames of 320x180")
    add("--timeout", type=float, default=1800, metavar="S", help="seconds a process may take (1800)")
    add("--json", action="store_true", help="print JSON instead of a table")
    options = parser.parse_args(words)
    options.frames = max(options.frames or (QUICK_FRAMES if options.quick else FRAMES), 2)
    options.size = options.size or ((320, 180) if options.quick else (960, 540))
    return options


def frames_to_each_side(text):
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"'{text}' is no number of frames")
    return int(text)


def frames_or_baked(text):
    return text if text == BAKED else frames_to_each_side(text)


def main(words, blender, environment, shared: Path | None) -> int:
    """`environment`: for a Blender with the extension installed."""
    options = parse(words)
    rows, failed = [], False
    for scene in options.scenes:
        for renderer in options.renderers:
            lines = [name for name in options.lines if renderer in LINES[name].renderers]
            if not lines:
                continue
            print(f"fovea: {scene}, {renderer}", file=sys.stderr, flush=True)
            asked = {
                "scene": scene, "renderer": renderer, "lines": lines, "anchor": options.anchor,
                "window": options.window if renderer == "fovea" else 0,
                "marks": options.marks if renderer == "fovea" and options.anchor == "path" else 0,
                "size": options.size, "frames": options.frames, "shared": str(shared or ""),
                "pictures": str(options.pictures.absolute()) if options.pictures else "",
            }  # fmt: skip
            found, problem = peers.measured(WORKER, asked, blender, environment, options.timeout)
            rows += found
            if problem:
                failed = True
                rows.append({**dict.fromkeys(COLUMNS), "scene": scene, "renderer": renderer, "problem": problem})
    print(peers.as_json(rows) if options.json else table(rows))
    return 1 if failed else 0


def table(rows):
    cells = [COLUMNS] + [tuple("" if row[name] is None else str(row[name]) for name in COLUMNS) for row in rows]
    widths = [max(len(line[k]) for line in cells) for k in range(len(COLUMNS))]
    lines = [
        "  ".join(cell.ljust(w) if k < 3 else cell.rjust(w) for k, (cell, w) in enumerate(zip(line, widths))).rstrip()
        for line in cells
    ]
    lines += [f"{row['scene']} {row['renderer']}: {row['problem']}" for row in rows if "problem" in row]
    return "\n".join(lines)
