# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea bench visibility`: compares all methods of line visibility on the same frames (Cole 2009, table 5.1).

One process per scene, in which all methods draw the same orbit. Runs in plain Python."""

import argparse
import sys
from pathlib import Path

from .. import peers

WORKER = Path(__file__).with_name("worker.py")
# Boxes with about 1.5k, 15k, 300k and 500k segments, including silhouettes, and a realistic scene.
SCENES = ("boxes:11", "boxes:35", "office", "boxes:158", "boxes:204")
METHODS = ("OGL", "IBlo", "IBhi", "STlo", "SThi", "SAlo", "SAhi", "exact")


def parse(words):
    parser = argparse.ArgumentParser("fovea bench visibility", description=__doc__)
    add = parser.add_argument
    add("--scenes", type=peers.scene_list, default=list(SCENES), metavar="A,B", help=", ".join(SCENES))
    add("--methods", type=peers.some_of(METHODS), default=list(METHODS), metavar="A,B", help=", ".join(METHODS))
    add("--frames", type=peers.count, default=20, metavar="N", help="of the orbit, one degree apart (20)")
    add("--size", type=peers.frame_size, default=(1024, 768), metavar="WxH", help="of the picture (1024x768)")
    add("--timeout", type=float, default=3600, metavar="S", help="seconds a scene may take (3600)")
    add("--json", action="store_true", help="print JSON instead of a table")
    return parser.parse_args(words)


def main(words, blender, environment, shared: Path | None) -> int:
    """`environment`: for a Blender with the extension installed."""
    options = parse(words)
    rows, problems = [], []
    for spec in options.scenes:
        print(f"fovea: {spec}", file=sys.stderr, flush=True)
        asked = {
            "scene": spec, "methods": options.methods, "frames": options.frames, "size": options.size,
            "shared": str(shared or ""),
        }  # fmt: skip
        found, problem = peers.measured(WORKER, asked, blender, environment | {"FOVEA_BACKEND": "gpu"}, options.timeout)
        rows += found
        problems += [f"{spec}: {problem}"] if problem else []
    print(peers.as_json(rows) if options.json else table(rows))
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


def table(rows):
    columns = ("scene", "method", "segments", "samples", "fps", "disagree", "flicker")
    cells = [(*columns, "stages, ms")] + [
        (*("-" if row[name] is None else str(row[name]) for name in columns), stages(row)) for row in rows
    ]
    widths = [max(len(line[k]) for line in cells) for k in range(len(columns) + 1)]
    return "\n".join(
        "  ".join(
            cell.rjust(w) if 2 <= k <= 6 else cell.ljust(w) for k, (cell, w) in enumerate(zip(line, widths))
        ).rstrip()
        for line in cells
    )


def stages(row):
    return ", ".join(f"{name} {ms:.1f}" for name, ms in row["stages"].items())
