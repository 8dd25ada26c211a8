# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea compare A B`: how near a drawing is to others, in Blender only where the lines of a scene are to explain them;
and sheets of paper to draw on."""

import argparse
import json
from pathlib import Path

from . import actions, model_files, output, quantities

SHEETS = "a4", "a3", "letter"
REPORTS = ".html", ".png"


def compare(target, words):
    options = parse(words)
    if options.output:
        output.check(options.output)
    if options.sheet:
        return write_sheet(target, options)
    if options.scene:
        found = json.loads(actions.written_by(target, f"drawing the lines of {options.scene}", "compare.py", words))
    else:
        compared = of_files(actions.imported(target, "comparison"), options)
        if options.output:
            actions.imported(target, "comparison_report").write(compared, options.output)
        found = finite(compared.found)
    print(json.dumps(found) if options.json else sentence(found))
    if options.output and not options.json:
        print(options.output)
    return 0


def of_files(comparison, options):
    drawings = [comparison.read(path) for path in (options.drawing, *options.judges)]
    return comparison.of_drawings(drawings, tolerance_of(comparison, options), options.register)


def tolerance_of(comparison, options):
    """The tolerance that is asked for, as the add-on has it."""
    asked = options.tolerance
    if isinstance(asked, quantities.OnPaper):
        return comparison.Millimeters(asked.millimeters, options.paper_width)
    return asked


def add_tolerance(parser):
    parser.add_argument(
        "--tolerance",
        type=quantities.tolerance,
        metavar="PX|MMmm",
        help="what counts as near (0.42 %% of the diagonal)",
    )
    width = quantities.within(1, quantities.MOST_PAPER, "millimeters")
    parser.add_argument("--paper-width", type=width, metavar="MM", help="of the frame on paper, for a tolerance in mm")


def check_tolerance(parser, options):
    if options.paper_width and not isinstance(options.tolerance, quantities.OnPaper):
        parser.error("--paper-width goes with a --tolerance in millimeters, as 1mm")


def write_sheet(target, options):
    gray = actions.imported(target, "comparison").read(options.drawing).gray
    if gray is None:
        raise ValueError(f"--sheet: {options.drawing.name} is no PNG: draw the picture to draw after as one")
    content = gray.prompt_sheet(actions.imported(target, "comparison").title(options.drawing), options.sheet)
    with output.written(options.output) as fresh:
        fresh.write_bytes(content)
    print(options.output)
    return 0


def parse(words):
    parser = argparse.ArgumentParser("fovea compare", usage=argparse.SUPPRESS)
    parser.add_argument("drawing", type=model_files.file, metavar="A")
    parser.add_argument("judges", type=model_files.file, nargs="*", metavar="B", help="drawings that A is judged by")
    add_tolerance(parser)
    by = ("lines", "marks")
    parser.add_argument("--register", choices=by, help="PNGs among B are scans, registered to A by that")
    parser.add_argument(
        "--scene", type=model_files.scene, help="NAME[:N], MODEL or FILE.blend: how its line definitions explain B"
    )
    parser.add_argument("--camera", metavar="NAME", help="of the scene")
    parser.add_argument("--lines", type=lambda text: text.split(","), metavar="A,B", help="line definitions")
    parser.add_argument("--model", dest="given", type=model_files.file, metavar="FILE", help="that a definition needs")
    parser.add_argument("-o", "--output", type=_output, metavar="OUT.html|OUT.png", help="report, or overlay")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--sheet", choices=SHEETS, help="-o OUT.pdf: paper to draw on after the picture A")
    options = parser.parse_args(words)
    if options.sheet:
        if options.judges or not options.output or options.output.suffix.lower() != ".pdf":
            parser.error("--sheet takes one picture, and -o OUT.pdf")
    elif not options.judges:
        parser.error("name two drawings: A is judged by B")
    elif options.output and options.output.suffix.lower() not in REPORTS:
        parser.error(f"-o: a report is one of {', '.join(REPORTS)}, not {options.output.name}")
    if (options.camera or options.lines) and not options.scene:
        parser.error("--camera and --lines go with --scene")
    if options.given and not options.lines:
        parser.error("--model goes with --lines")
    check_tolerance(parser, options)
    return options


def _output(text):
    return Path(text).absolute()


def finite(found):
    """The same without infinite numbers, which JSON does not have: None."""
    if isinstance(found, dict):
        return {name: finite(value) for name, value in found.items()}
    if isinstance(found, list):
        return [finite(value) for value in found]
    return None if isinstance(found, float) and not abs(found) < float("inf") else found


def sentence(found):
    chamfer = "infinite" if found["chamfer_px"] is None else f"{found['chamfer_px']:.2f} px"
    return (
        f"precision {found['precision']:.3f}, recall {found['recall']:.3f}, F1 {found['f1']:.3f}, "
        f"chamfer distance {chamfer}, IoU {found['iou']:.3f}, within {within(found)}"
    )


def within(found):
    on_paper = f", {found['tolerance_mm']:g} mm on paper" if "tolerance_mm" in found else ""
    return f"{found['tolerance_px']:.2f} px{on_paper}"
