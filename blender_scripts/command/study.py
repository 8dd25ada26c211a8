# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea study make SCENE` and `fovea study analyse FOLDER...`: whether drawings show the shape of what is drawn, by
gauges that people set on them; in Blender only to make the pictures."""

import argparse
import hashlib
import json
import math
import os
import re
import secrets
import shutil
import tempfile
import tomllib
from pathlib import Path

from gauges import analysis, formulas, page, records, report, several

from . import actions, draw_options, output, quantities
from .target import PROJECT

SIZE = 1024, 768
SHADED = "shaded"  # a picture that is no drawing, to compare drawings with
PAGE = "study.html"


def study(target, words):
    options = parse(words)
    return {"make": make, "analyse": analyse}[options.what](target, options)


def parse(words):
    parser = argparse.ArgumentParser("fovea study", usage=argparse.SUPPRESS)
    parts = parser.add_subparsers(dest="what", required=True)
    made = parts.add_parser("make", usage=argparse.SUPPRESS, allow_abbrev=False)
    made.add_argument("scene", help="what `fovea draw` draws")
    made.add_argument("--styles", type=lambda text: text.split(","), required=True, metavar="A,B")
    made.add_argument("--gauges", type=_count, default=90, metavar="N")
    made.add_argument("--string", type=_string, action="append", default=[], metavar="U,V,DEGREES")
    made.add_argument("--size", type=quantities.frame_size, default=SIZE, metavar="WxH")
    made.add_argument("--seed", type=_seed, default=0, metavar="N", help="other places")
    made.add_argument("-o", "--output", type=_path, required=True, metavar="FOLDER")
    analysed = parts.add_parser("analyse", usage=argparse.SUPPRESS, allow_abbrev=False)
    analysed.add_argument("folders", type=_path, nargs="+", metavar="FOLDER")
    analysed.add_argument("--json", action="store_true")
    analysed.add_argument("-o", "--output", type=_path, metavar="REPORT.html")
    options, rest = parser.parse_known_args(words)
    try:
        if options.what == "make":
            _check_made(options, rest)
        else:
            _check_analysed(options, rest)
    except ValueError as error:
        parser.error(str(error))
    return options


def _check_made(options, rest):
    options.names = {style: _name_of(style) for style in options.styles}
    if len(set(options.names.values())) < len(options.styles):
        raise ValueError("--styles: two have the same name: people would not be told apart by what they saw")
    width, height = options.size
    drawing = Path(tempfile.gettempdir(), "drawing.png")  # is not written
    options.draw = [options.scene, "--size", f"{width}x{height}", *rest, "-o", str(drawing)]
    folder = options.output
    if not folder.parent.is_dir():
        raise ValueError(f"there is no folder {folder.parent}")
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise ValueError(f"{folder} is not empty: name a new folder, as settings belong to the pictures they are of")
    output.check_folder(folder)
    drawn = draw_options.parse(options.draw)
    for name in ("style", "frames", "cameras", "over", "sheet", "dump", "one_bit"):
        if getattr(drawn, name) and (name != "style" or "--style" in rest):
            raise ValueError(
                f"--{name.replace('_', '-')} is for fovea draw: a study has one picture for each of --styles"
            )


def _name_of(style):
    name = Path(style).stem if style.endswith(".json") else style
    if not re.fullmatch(r"[\w-]+", name):
        raise ValueError(f"--styles: '{style}' is no name of letters and digits, nor a .json file of such a name")
    return name


def _check_analysed(options, rest):
    if rest:
        raise ValueError(f"{' '.join(rest)}: analyse takes folders, --json and -o REPORT.html")
    if options.output and options.output.suffix.lower() != ".html":
        raise ValueError(f"-o: a report is a .html, not {options.output.name}")
    if options.output:
        output.check(options.output)


def _path(text):
    return Path(text).absolute()


def _count(text):
    count = int(text) if text.isdecimal() else 0
    if not 3 <= count <= 1000:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number of gauges from 3 to 1000")
    return count


def _string(text):
    try:
        u, v, degrees = map(float, text.split(","))
    except ValueError:
        u = v = degrees = math.nan
    if not (0 <= u <= 1 and 0 <= v <= 1 and math.isfinite(degrees)):
        raise argparse.ArgumentTypeError(
            f"'{text}' is not a place from the left and the top, both 0 to 1, and an angle, as 0.4,0.5,90"
        )
    return u, v, degrees


def _seed(text):
    if not text.isdecimal() or int(text) > 9999:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from 0 to 9999")
    return int(text)


def make(target, options):
    for style in options.styles:
        if style != SHADED:
            actions.check_style(target, style)
    work = Path(os.environ["TMPDIR"], "study")
    work.mkdir()
    pictures = {name: work / f"{name}.png" for name in options.names.values()}
    asked = {
        "draw": options.draw, "gauges": options.gauges, "seed": options.seed,
        "strings": options.string, "shaded": SHADED, "pictures": {name: str(path) for name, path in pictures.items()},
        "styles": {name: [] if style == SHADED else ["--style", style] for style, name in options.names.items()},
    }  # fmt: skip
    found = json.loads(actions.written_by(target, f"drawing {options.scene} for a study", "study.py", asked))
    drawn = {name: path.read_bytes() for name, path in pictures.items()}
    told = described(options, found, drawn)
    files = {f"{name}.png": content for name, content in drawn.items()}
    files |= {records.STUDY: json.dumps(told, indent=1).encode(), PAGE: page.page(told, drawn).encode()}
    _write_all(options.output, files)
    for name in files:
        print(options.output / name)
    return 0


def _write_all(folder, files):
    """Writes files (name -> bytes) to a folder that is new or empty: all of them or, on an error or interrupt, none. A
    folder that is there is filled, not replaced, as it may be a mount."""
    is_new = not folder.exists()
    fresh = (folder.parent if is_new else folder) / f".{secrets.token_hex(8)}"
    moved = []
    try:
        fresh.mkdir()
        for name, content in files.items():
            (fresh / name).write_bytes(content)
        if is_new:
            fresh.rename(folder)
        else:
            for name in files:
                moved.append(folder / name)
                (fresh / name).rename(folder / name)
    except OSError as error:
        told = f"{folder} could not be written ({error.strerror}): make room, or name another place"
        raise ValueError(told) from error
    else:
        moved.clear()
    finally:
        for path in moved:
            path.unlink(missing_ok=True)
        shutil.rmtree(fresh, ignore_errors=True)


def described(options, found, pictures):
    """What study.json has. `found`: what the script in Blender tells; `pictures`: {style: bytes of its PNG file}."""
    version = tomllib.loads((PROJECT / "addon" / "blender_manifest.toml").read_text(encoding="utf-8"))["version"]
    scene = Path(options.scene).stem if draw_options.is_file(options.scene) else options.scene.replace(":", "-")
    told = {
        "study": "", "build": f"Fovea {version}, Blender {found['blender']}", "model": scene,
        "size": list(options.size), "radius": formulas.RADIUS * options.size[1], "seed": options.seed,
        "tried": found["tried"], "draw": options.draw[:-2],
        "stimuli": [
            {"style": name, "file": f"{name}.png", "sha256": hashlib.sha256(content).hexdigest()}
            for name, content in pictures.items()
        ],
        "gauges": found["gauges"], "strings": found.get("strings", []),
    }  # fmt: skip
    told["study"] = hashlib.sha256(json.dumps(told).encode()).hexdigest()[:12]
    return told


def _write(path, text):
    with output.written(path) as fresh:
        fresh.write_text(text, encoding="utf-8")


def analyse(target, options):
    core = actions.imported(target, "native").load()
    studies = [records.read_study(folder) for folder in options.folders]
    several.check(studies)
    found = [analysis.analyse(core, made, _sessions(made)) for made in studies]
    if len(found) > 1:
        of, shown, told = several, found, several.told(found)
    else:
        of, shown, told = report, found[0], analysis.told(found[0])
    print(json.dumps(told) if options.json else of.text(told))
    if options.output:
        _write(options.output, of.page(shown, told))
        if not options.json:
            print(options.output)
    return 0


def _sessions(made):
    found = records.read_sessions(made)
    if not found:
        raise ValueError(f"{made.folder} has no settings: put the .jsonl files there that participants have saved")
    return found
