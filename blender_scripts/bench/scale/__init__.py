# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea bench scale`: first frame, moved frame and memory of large scenes, at counts that grow.

grid: triangles of one surface; instances: of a collection, by geometry nodes; objects: separate ones of one mesh;
picture: pixels of boxes:100, up to 8k. One process per scene and count; runs in plain Python. Exponents are those of n
from the count before. Where a scene is over its bound, that is said and the exit status is 1.

blank_s and blank_mb: what Blender itself takes for a frame of the scene, by an engine that draws nothing; own_mb: what
the peak of Fovea's frames, peak_mb, is above that. Of many objects nearly all memory is Blender's, so that Fovea's own
is bound there, else that of the process."""

import argparse
import math
import sys
from pathlib import Path

from .. import peers

WORKER = Path(__file__).with_name("worker.py")
COUNTS = {
    "grid": (1_000_000, 3_000_000, 10_000_000),
    "instances": (100_000, 300_000, 1_000_000),
    "objects": (10_000, 30_000, 100_000),
    "picture": (1920 * 1080, 3840 * 2160, 7680 * 4320),
}
QUICK = 100  # the counts are divided by it
BOUNDS = {  # (scene, count): the most that columns may be, with two free cores
    ("grid", 10_000_000): {"first_s": 5, "peak_mb": 2200},
    ("instances", 1_000_000): {"first_s": 12, "peak_mb": 3000},
    ("objects", 100_000): {"first_s": 12, "own_mb": 3000},
}
GROWING = ("first_s", "moved_s", "peak_mb")  # whose exponents are told
COLUMNS = ("scene", "count", *GROWING, "own_mb", "blank_s", "blank_mb", "scene_mb", "strokes")


def parse(words):
    parser = argparse.ArgumentParser("fovea bench scale", description=__doc__)
    add = parser.add_argument
    names = ", ".join(COUNTS)
    add("--scenes", type=scene_list, metavar="A,B", help=f"{names}, or one count of one, as grid:500000")
    add("--size", type=peers.frame_size, default=(1920, 1080), metavar="WxH", help="of all but picture (1920x1080)")
    add("--quick", action="store_true", help=f"a {QUICK}th of the counts")
    add("--timeout", type=float, default=900, metavar="S", help="seconds a scene may take (900)")
    add("--json", action="store_true", help="print JSON instead of a table")
    options = parser.parse_args(words)
    given = options.scenes or [(name, None) for name in COUNTS]
    share = QUICK if options.quick else 1
    options.scenes = [(name, one) for name, n in given for one in ([n] if n else [m // share for m in COUNTS[name]])]
    return options


def scene_list(text):
    """[(name, count)] of a list of scenes; count None: all counts of the scene."""
    found = []
    for word in text.split(","):
        name, _, number = word.partition(":")
        if name not in COUNTS:
            raise argparse.ArgumentTypeError(f"'{name}' is none of {', '.join(COUNTS)}")
        found.append((name, peers.count(number) if number else None))
    return found


def main(words, blender, environment, _shared: Path | None) -> int:
    """`environment`: for a Blender with the extension installed."""
    options, rows = parse(words), []
    for name, count in options.scenes:
        print(f"fovea: {name}, {count:,} ({len(rows) + 1} of {len(options.scenes)})", file=sys.stderr, flush=True)
        asked = {"scene": name, "count": count, "size": options.size}
        record, problem = peers.measured(WORKER, asked, blender, environment, options.timeout)
        problem = {"problem": problem} if problem else {}
        rows.append({"scene": name, "count": count, **dict.fromkeys(COLUMNS[2:]), **dict(record), **problem})
    for row, grown in zip(rows, exponents(rows)):
        row["exponents"] = {name: round(k, 3) for name, k in grown.items()}
    print(peers.as_json(rows) if options.json else table(rows))
    excess = [told for row in rows for told in over(row)]
    for told in excess:
        print(f"fovea: {told}", file=sys.stderr)
    return 1 if excess or any("problem" in row for row in rows) else 0


def over(row):
    """Sentences on what of a row is over its bound."""
    bound = BOUNDS.get((row["scene"], row["count"]), {})
    where = f"{row['scene']}, {row['count']:,}: over its bound"
    return [f"{where}, {name} {row[name]} of {most}" for name, most in bound.items() if (row[name] or 0) > most]


def exponents(rows):
    """Per row, {column: k}: it grew as the count to the power of k since the row before; {} for a scene's first."""
    found = [{}]
    for before, row in zip(rows, rows[1:]):
        same = row["scene"] == before["scene"] and row["count"] != before["count"]
        both = [name for name in GROWING if same and before[name] and row[name]]
        grown = {name: math.log(row[name] / before[name]) / math.log(row["count"] / before["count"]) for name in both}
        found.append(grown)
    return found[: len(rows)]


def table(rows):
    cells = [(*COLUMNS, "exponents", "at most")]
    for row, grown in zip(rows, exponents(rows)):
        told = ", ".join(f"{name[: name.index('_')]} {k:.2f}" for name, k in grown.items())
        bound = BOUNDS.get((row["scene"], row["count"]))
        cells.append((*("" if row[name] is None else str(row[name]) for name in COLUMNS), told, in_words(bound)))
    widths = [max(len(line[k]) for line in cells) for k in range(len(cells[0]))]
    left = (0, len(COLUMNS), len(COLUMNS) + 1)
    lines = [
        "  ".join(cell.ljust(w) if k in left else cell.rjust(w) for k, (cell, w) in enumerate(zip(line, widths)))
        for line in cells
    ]
    for row in rows:
        for frame in ("first", "moved"):
            if stages := row.get(f"{frame}_stages"):
                seconds = ", ".join(f"{name} {s:.2f}" for name, s in stages.items())
                lines.append(f"{row['scene']} {row['count']}, s of the {frame} frame: {seconds}")
        if "problem" in row:
            lines.append(f"{row['scene']} {row['count']}: {row['problem']}")
    return "\n".join(line.rstrip() for line in lines)


def in_words(bound):
    return ", ".join(f"{name} {most}" for name, most in (bound or {}).items())
