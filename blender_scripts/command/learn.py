# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea learn SCENE DRAWING... -o MODEL.json`: where an artist draws lines, as a model of what is known of each pixel;
and `fovea learn --predict SCENE --model MODEL.json -o OUT.png`: the lines that it draws of a scene."""

import argparse
import json
from pathlib import Path

from . import actions, model_files, output, quantities

KINDS = "regression", "tree", "forest"
OF_LEARNING = "kind", "tolerance", "register"  # words that only learning takes
OF_PREDICTING = "model", "threshold", "size", "probability"


def learn(target, words):
    options = parse(words)
    output.check(options.output)
    doing = "drawing" if options.predict else "learning the lines of"
    found = json.loads(actions.written_by(target, f"{doing} {options.scene}", "learn.py", words))
    print(json.dumps(found) if options.json else found["picture"] if options.predict else told(found))
    return 0


def parse(words):
    parser = argparse.ArgumentParser("fovea learn", usage=argparse.SUPPRESS)
    parser.add_argument("scene", type=model_files.scene, help="NAME[:N], MODEL or FILE.blend")
    of_drawing = {"type": model_files.file, "metavar": "DRAWING", "nargs": "*"}
    parser.add_argument("drawings", help="of the same view: .png, .svg or .npz", **of_drawing)
    path = {"type": lambda text: Path(text).absolute(), "metavar": "MODEL.json|OUT.png"}
    parser.add_argument("-o", "--output", required=True, help="the model, or the picture of --predict", **path)
    parser.add_argument("--kind", choices=KINDS, help="of the model: tree, unless it is said")
    far = quantities.within(0, 1e4, "pixels")
    parser.add_argument("--tolerance", type=far, metavar="PX", help="what counts as near (0.42 %% of the diagonal)")
    by = ("lines", "marks")
    parser.add_argument("--register", choices=by, help="scans, registered to the lines of the scene by that")
    parser.add_argument("--camera", metavar="NAME", help="of the scene")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--predict", action="store_true", help="draws the scene by a model")
    parser.add_argument("--model", type=model_files.file, metavar="MODEL.json")
    parser.add_argument(
        "--threshold", type=quantities.within(0, 1, "shares"), help="probability from which on lines are drawn"
    )
    parser.add_argument("--size", type=quantities.frame_size, metavar="WxH", help="of the picture")
    parser.add_argument("--probability", action="store_true", help="the picture of probabilities, not of lines")
    options = parser.parse_intermixed_args(words)
    _check(parser, options)
    options.kind = options.kind or "tree"
    return options


def _check(parser, options):
    """Ends with a sentence where words do not go together."""
    does, takes_no = ("--predict", OF_LEARNING) if options.predict else ("learning from drawings", OF_PREDICTING)
    for name in takes_no:
        if getattr(options, name):
            parser.error(f"--{name} does not go with {does}")
    if options.predict and (options.drawings or not options.model):
        parser.error("--predict takes one scene, and --model MODEL.json")
    if not options.predict and not options.drawings:
        parser.error("name a drawing of the scene to learn from, or --predict")
    suffix = ".png" if options.predict else ".json"
    if options.output.suffix.lower() != suffix:
        what = "a picture" if options.predict else "a model"
        parser.error(f"-o: {what} is a {suffix}, not {options.output.name}")


def told(found):
    """Lines of words: how well the model knows pixels that it has not learned from, its lines, and what it goes by."""
    r2, auc = ("unknown" if found[name] is None else f"{found[name]:.3f}" for name in ("r2", "auc"))
    measures = "precision {precision:.3f}, recall {recall:.3f}, F1 {f1:.3f}".format(**found)
    lines = [
        f"of {found['pixels']} pixels held out: R2 {r2}, AUC {auc}",
        f"lines from {found['threshold']:.2f} on: {measures}, within {found['tolerance_px']:.2f} px",
        "importance:" if found["importance"] else "importance: unknown, as all pixels held out are alike",
        *(f"  {name:28}{share:.3f}" for name, share in found["importance"].items()),
    ]
    return "\n".join([*lines, found["model"]])
