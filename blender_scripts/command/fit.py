# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea fit SCENE DRAWING... -o STYLE.json`: the style, by its line definitions and their thresholds, that draws a
scene as artists have drawn it."""

import argparse
import json
from pathlib import Path

from . import actions, compare, model_files, output, quantities

BASE = "plain"  # what fitted lines are drawn with, unless --style says it
BETA = 0.5, 2.0  # from clean to complete


def fit(target, words):
    options = parse(words)
    output.check(options.output)
    found = json.loads(actions.written_by(target, f"fitting the lines of {options.scene}", "fit.py", words))
    print(json.dumps(found) if options.json else told(found))
    return 0


def parse(words):
    parser = argparse.ArgumentParser("fovea fit", usage=argparse.SUPPRESS)
    parser.add_argument("scene", type=model_files.scene, help="NAME[:N], MODEL or FILE.blend")
    drawing = {"type": model_files.file, "metavar": "DRAWING", "nargs": "+"}
    parser.add_argument("drawings", help="of artists: .png, .svg or .npz", **drawing)
    path = {"type": lambda text: Path(text).absolute(), "metavar": "STYLE.json"}
    parser.add_argument("-o", "--output", required=True, help="the style", **path)
    parser.add_argument("--style", default=BASE, metavar="NAME|FILE.json", help="whose pens draw the lines")
    parser.add_argument("--lines", type=lambda text: text.split(","), metavar="A,B", help="line definitions")
    parser.add_argument("--camera", metavar="NAME", help="of the scene")
    compare.add_tolerance(parser)
    beta = quantities.within(*BETA, "times the weight of precision")
    parser.add_argument("--beta", type=beta, default=1.0, help="above 1: rather complete than clean")
    by = ("lines", "marks")
    parser.add_argument("--register", choices=by, help="a scan, registered to the lines of the scene by that")
    parser.add_argument(
        "--keep-pens", action="store_true", help="pens and hand are those of --style, not the drawing's"
    )
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args(words)
    if options.output.suffix.lower() != ".json":
        parser.error(f"-o: a style is a .json, not {options.output.name}")
    compare.check_tolerance(parser, options)
    return options


def told(found):
    """Lines of words: how near the drawing is, and what is drawn from which threshold on."""
    measures = "precision {precision:.3f}, recall {recall:.3f}, F1 {f1:.3f}"
    lines = [f"{measures.format(**found)}, within {found['tolerance_px']:.2f} px; F1 was {found['before']['f1']:.3f}"]
    judges = found["judged_by"]
    lines += [f"  {one['name']:24}{measures.format(**one)}" for one in judges if len(judges) > 1]
    held_out = "drawings" if len(judges) > 1 else "parts of the drawing"
    lines.append(f"F1 {found['cross_validated_f1']:.3f} of {held_out} that were held out of the fit")
    for name, value in found["thresholds"].items():
        lines.append(f"  {name:24}{'off' if value is None else 'on' if value is True else f'{value:.4g}'}")
    for pen in found["pens"]:
        dark = "" if pen["darkness"] is None else f", {pen['darkness']:.0%} dark"
        lines.append(f"  pen of {pen['name']:17}{pen['width']:.2f} px wide{dark}")
    lines += [f"  hand of {hand['name']:16}{_hand(hand)}" for hand in found["hands"]]
    return "\n".join([*lines, found["style"]])


def _hand(hand):
    """What is known of how a line set's strokes are drawn."""
    far, wobble, wave = hand["overshoot"], hand["wobble"], hand["wobble_length"]
    over = "overshoot unknown" if far is None else f"overshoot {far:.1f} px" if far else "no overshoot"
    return f"{over}, wobble {wobble:.1f} px in waves of {wave:.0f} px" if wave else f"{over}, no wobble"
