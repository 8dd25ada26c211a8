# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea bench viewport`: compares Rendered with Solid shading in the 3D view, in a window under Xvfb, overlays off.

Both orbit alternately in one process. `first`: time from switching to Rendered to the first picture; `refined`: to the
final one. `solid` and `fovea`: median times of an orbit's frame; `new`: share of Fovea's frames with a new picture
(else the last one stays). `drawing`: the longest time that Fovea blocked the interface; `block`: the longest frame or
iteration of Blender's main loop, including software OpenGL, from switching to Rendered until the orbit's last picture
was refined. `idle`: share of a core used at rest, `idle_solid`: in Solid; `idle_draws`: draws of the viewport at rest.
"""

import argparse
import sys
import tempfile
from pathlib import Path

import window

from .. import peers

SCENES = ("office", "boxes:30")
SCENARIO = Path(__file__).with_name("scenario.py")
COLUMNS = (
    "scene", "triangles", "first_ms", "refined_ms", "solid_ms", "fovea_ms", "ratio", "new", "drawing_ms", "block_ms",
    "idle", "idle_solid", "idle_draws",
)  # fmt: skip


def parse(words):
    parser = argparse.ArgumentParser("fovea bench viewport", description=__doc__)
    add = parser.add_argument
    add("--scenes", type=peers.scene_list, default=list(SCENES), metavar="A,B", help=", ".join(SCENES))
    add("--size", type=peers.frame_size, default=(960, 540), metavar="WxH", help="of the view (960x540)")
    add("--frames", type=peers.count, default=30, metavar="N", help="of the orbit, two degrees apart (30)")
    add("--rest", type=float, default=3, metavar="S", help="seconds that it is watched idling (3)")
    add("--style", default="", metavar="NAME", help="instead of the default one")
    add("--timeout", type=float, default=300, metavar="S", help="seconds a scene may take (300)")
    add("--json", action="store_true", help="print JSON instead of a table")
    return parser.parse_args(words)


def main(words, blender, environment, shared: Path | None) -> int:
    """`environment`: for a Blender with the extension installed."""
    options, rows, failed = parse(words), [], False
    for spec in options.scenes:
        print(f"fovea: {spec}", file=sys.stderr, flush=True)
        asked = spec, shared or "", options.frames, options.style, options.rest
        how = {"size": options.size, "timeout": options.timeout}
        with tempfile.TemporaryDirectory() as folder:
            try:
                played = window.play(blender, environment, SCENARIO, "measure", Path(folder), asked, **how)
                rows.append(played.result)
            except window.Failed as failure:
                print(f"{spec}: {failure}", file=sys.stderr)
                failed = True
    print(peers.as_json(rows) if options.json else table(rows))
    return 1 if failed else 0


def table(rows):
    cells = [COLUMNS] + [tuple(str(row[name]) for name in COLUMNS) for row in rows]
    widths = [max(len(line[k]) for line in cells) for k in range(len(COLUMNS))]
    lines = ["  ".join(cell.rjust(w) for cell, w in zip(line, widths)) for line in cells]
    lines += [f"{row['scene']}, ms of the orbit's last draft: {stages(row)}" for row in rows]
    return "\n".join(lines)


def stages(row):
    return ", ".join(f"{name} {ms:.1f}" for name, ms in row["stages"].items())
