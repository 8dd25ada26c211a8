# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea bench focus`: measures whether line elision and stylized focus meet their targets on rendered scenes.

One process per part and scene. Runs in plain Python."""

import argparse
import sys
from pathlib import Path

from .. import peers

WORKER = Path(__file__).with_name("worker.py")
SCENES = {  # part -> its default scenes
    "density": ("office", "demo"),
    "coherence": ("suzanne:3", "office"),
    "cost": ("office", "boxes:30", "boxes:100", "boxes:200"),
    "emphasis": ("office",),
    "salience": ("office",),
}
PARTS = tuple(SCENES)
QUICK_FRAMES, FRAMES = 10, 40
MOST_FRAMES = 8  # frames to each side: a style's limit


def parse(words):
    parser = argparse.ArgumentParser("fovea bench focus", description=__doc__)
    add = parser.add_argument
    add("--parts", type=peers.some_of(PARTS), default=list(PARTS), metavar="A,B", help=", ".join(PARTS))
    add("--scenes", type=peers.scene_list, metavar="A,B", help="instead of those of each part")
    add("--size", type=peers.frame_size, default=(1920, 1080), metavar="WxH", help="of the picture (1920x1080)")
    add("--distance", type=float, default=10.0, metavar="PX", help="that lines keep, of 1080 pixels (10)")
    add("--smoothed", type=some_frames, default=[1, 2, 3], metavar="A,B", help="frames to each side, in time (1,2,3)")
    add("--frames", type=peers.count, metavar="N", help=f"of the coherence ({FRAMES})")
    add("--quick", action="store_true", help=f"{QUICK_FRAMES} frames, not {FRAMES}; one place to look at, not three")
    add("--timeout", type=float, default=3600, metavar="S", help="seconds a part of a scene may take (3600)")
    add("--json", action="store_true", help="print JSON instead of a table")
    options = parser.parse_args(words)
    options.frames = options.frames or (QUICK_FRAMES if options.quick else FRAMES)
    return options


def some_frames(text):
    """Parses a list of numbers of frames to each side over which elision is smoothed in time."""
    known = [str(frames) for frames in range(1, MOST_FRAMES + 1)]
    return sorted({int(word) for word in peers.some_of(known)(text)})


def main(words, blender, environment, shared: Path | None) -> int:
    """`environment`: for a Blender with the extension installed."""
    options = parse(words)
    rows, problems = [], []
    for part in options.parts:
        for spec in options.scenes or SCENES[part]:
            print(f"fovea: {part}, {spec}", file=sys.stderr, flush=True)
            asked = {
                "part": part, "scene": spec, "size": options.size, "distance": options.distance,
                "frames": options.frames, "places": 1 if options.quick else 3, "smoothed": options.smoothed,
                "shared": str(shared or ""),
            }  # fmt: skip
            gpu = {"FOVEA_BACKEND": "gpu"} if part == "cost" else {}
            found, problem = peers.measured(WORKER, asked, blender, environment | gpu, options.timeout)
            rows += found
            problems += [f"{part}, {spec}: {problem}"] if problem else []
    if "cost" in options.parts:
        rows += linearity(rows)
    print(peers.as_json(rows) if options.json else table(rows))
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


def linearity(rows):
    """Rows with the ratio of the costs per sample between scenes, the highest over the lowest."""
    found = []
    for figure in (PER_SAMPLE, PER_ATLAS_SAMPLE):
        costs = [row["value"] for row in rows if row["figure"] == figure]
        if len(costs) > 1:
            ratio, words = round(max(costs) / min(costs), 3), f"{figure}, dearest scene over cheapest"
            found.append({"figure": words, "scene": "all", "value": ratio, "wanted": None})
    return found


PER_SAMPLE = "elision, microseconds per sample drawn"
PER_ATLAS_SAMPLE = "elision, microseconds per sample, hidden ones included"


def table(rows):
    columns = ("figure", "scene", "value", "wanted")
    cells = [columns] + [(row["figure"], row["scene"], f"{row['value']:.4g}", row["wanted"] or "-") for row in rows]
    widths = [max(len(line[k]) for line in cells) for k in range(4)]
    return "\n".join(
        "  ".join(cell.rjust(w) if k == 2 else cell.ljust(w) for k, (cell, w) in enumerate(zip(line, widths))).rstrip()
        for line in cells
    )
