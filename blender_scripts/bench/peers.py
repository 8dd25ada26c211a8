# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea bench peers`: compares Fovea with Workbench, Freestyle and Line Art, on the same scenes and lines.

One process per scene and renderer, sequentially; runs in plain Python. Freestyle draws one frame only, not a second one
after the camera has moved."""

import argparse
import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import scenes

SCENES = ("boxes:100", "suzanne:5", "boxes:30")
RENDERERS = ("workbench", "freestyle", "lineart", "fovea-cpu", "fovea-gpu")
WORKER = Path(__file__).with_name("worker.py")
SIGN_OF_LIFE = 15  # seconds between progress messages


def parse(words):
    parser = argparse.ArgumentParser("fovea bench peers", description=__doc__)
    add = parser.add_argument
    add("--scenes", type=scene_list, default=list(SCENES), metavar="A,B", help=", ".join(SCENES))
    add("--renderers", type=some_of(RENDERERS), metavar="A,B", help=", ".join(RENDERERS))
    add("--size", type=frame_size, default=(1920, 1080), metavar="WxH", help="of the picture (1920x1080)")
    add("--repeats", type=count, metavar="N", help="of which medians are taken (5); Freestyle draws one frame")
    add("--quick", action="store_true", help="without Freestyle, medians of 3")
    add("--timeout", type=float, default=900, metavar="S", help="seconds a process may take (900)")
    add("--json", action="store_true", help="print JSON instead of a table")
    options = parser.parse_args(words)
    options.renderers = options.renderers or [r for r in RENDERERS if not (options.quick and r == "freestyle")]
    options.repeats = options.repeats or (3 if options.quick else 5)
    return options


def some_of(known):
    """An argparse type: comma-separated lists of these names."""

    def parse_names(text):
        unknown = set(text.split(",")) - set(known)
        if unknown:
            raise argparse.ArgumentTypeError(f"{', '.join(sorted(unknown))} is none of {', '.join(known)}")
        return text.split(",")

    return parse_names


def count(text):
    """A whole number, at least 1."""
    if not (text.isdecimal() and int(text)):
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from 1 on")
    return int(text)


def frame_size(text):
    width, _, height = text.partition("x")
    if not (width.isdecimal() and height.isdecimal() and int(width) and int(height)):
        raise argparse.ArgumentTypeError(f"'{text}' is not WIDTHxHEIGHT")
    return int(width), int(height)


def scene_list(text):
    try:
        for spec in text.split(","):
            scenes.parse(spec)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return text.split(",")


def main(words, blender, environment, shared: Path | None) -> int:
    """`environment`: for a Blender with the extension installed."""
    options = parse(words)
    rows = []
    for spec in options.scenes:
        for renderer in options.renderers:
            place = f"{len(rows) + 1} of {len(options.scenes) * len(options.renderers)}"
            print(f"fovea: {spec}, {renderer} ({place})", file=sys.stderr, flush=True)
            asked = {
                "scene": spec, "renderer": renderer, "size": options.size, "shared": str(shared or ""),
                "repeats": options.repeats,
            }  # fmt: skip
            record, problem = measured(WORKER, asked, blender, environment, options.timeout)
            rows.append(row(spec, renderer, record or {}, problem))
    print(as_json(rows) if options.json else table(rows))
    return 1 if any("problem" in row for row in rows) else 0


def run(command, environment, timeout, log):
    """Runs a command with its output in the file `log`, and prints the last line of it every SIGN_OF_LIFE seconds.
    Returns None, or a sentence on the failure; kills the command after `timeout` seconds."""
    streams = {"stdin": subprocess.DEVNULL, "stderr": subprocess.STDOUT}
    with log.open("wb") as output, subprocess.Popen(command, env=environment, stdout=output, **streams) as process:
        start, spent = time.monotonic(), 0.0
        while spent < timeout:
            try:
                process.wait(min(SIGN_OF_LIFE, timeout - spent))
                break
            except subprocess.TimeoutExpired:
                spent = time.monotonic() - start
                print(f"fovea:   {spent:.0f} s: {' '.join(last_lines(log, 1))[:100]}", file=sys.stderr, flush=True)
        else:
            process.kill()
            return f"stopped after {timeout:.0f} s"
    if process.returncode == 0:
        return None
    said = [line for line in last_lines(log) if line.startswith("Error: ")] or last_lines(log, 3)
    return f"ended with {process.returncode}: {' '.join(said)}"


def last_lines(log, count=0):
    """The last `count` lines of a log; 0: all."""
    return log.read_text(encoding="utf-8", errors="replace").splitlines()[-count:]


def row(spec, renderer, record, problem):
    """The result row of one process; None for values that were not measured."""
    first, moved = record.get("first", []), record.get("moved", [])
    made = {
        "scene": spec,
        "renderer": renderer,
        "triangles": record.get("triangles"),
        "first_s": median(first, "wall_s"),
        "moved_s": median(moved, "wall_s"),
        "peak_mb": round(record["peak_mb"], 1) if "peak_mb" in record else None,
        "strokes": first[0].get("strokes") if first else None,
    }
    if renderer.startswith("fovea"):
        stages = [frame["stages"] for frame in first]
        made["stages"] = {name: median(stages, name) for name in (stages[0] if stages else ())}
        made["lines_s"], made["lines_moved_s"] = median(first, "lines_s"), median(moved, "lines_s")
    if problem:
        made["problem"] = problem
    return made


def median(frames, field):
    return round(statistics.median(frame[field] for frame in frames), 4) if frames else None


def measured(worker, asked, blender, environment, timeout):
    """(result, problem): the JSON that a worker script writes in a new Blender process, [] if none; problem as of
    `run`."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "rows.json"
        words = json.dumps({**asked, "out": str(out)})
        command = [blender, "-b", "--python-exit-code", "1", "-P", str(worker), "--", words]
        problem = run(command, environment, timeout, Path(folder) / "log")
        return json.loads(out.read_text()) if out.is_file() else [], problem


def as_json(rows):
    return "[" + ",\n ".join(json.dumps(row) for row in rows) + "]"


def table(rows):
    columns = ("scene", "renderer", "triangles", "first_s", "moved_s", "peak_mb", "strokes", "lines_s", "lines_moved_s")
    cells = [columns] + [tuple("" if row.get(name) is None else str(row[name]) for name in columns) for row in rows]
    widths = [max(len(line[k]) for line in cells) for k in range(len(columns))]
    lines = [
        "  ".join(cell.ljust(w) if k < 2 else cell.rjust(w) for k, (cell, w) in enumerate(zip(line, widths))).rstrip()
        for line in cells
    ]
    for row in rows:
        if row.get("stages"):
            stages = ", ".join(f"{name} {ms:.1f}" for name, ms in row["stages"].items())
            lines.append(f"{row['scene']} {row['renderer']}, ms of the first frame: {stages}")
        if "problem" in row:
            lines.append(f"{row['scene']} {row['renderer']}: {row['problem']}")
    return "\n".join(lines)
