"""Runs inside Blender for `fovea figures lines`: each line definition of command/pages.py over a faint drawing of the
model that shows it."""

import argparse
import sys
import tempfile
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))

import draw
import sheet
from command import draw_options, pages
from command.target import SHARED
from scenes import lessons

FAINT = {"pen_width": 2.8, "pen_color": (0.4, 0.4, 0.4), "pen_taper": 0.0}
BOLD = {"pen_width": 7.5, "pen_color": (0.0, 0.0, 0.0), "pen_taper": 0.0, "pen_strength_width": 0.5}
GREYS = 16  # fewer make smaller files


def main(words):
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("names", nargs="+")
    options = parser.parse_args(words)
    with tempfile.TemporaryDirectory() as folder:
        for name in options.names:
            shown = pages.LINES[name.removeprefix("lines/")]
            open_model(shown.model)
            picture = Path(folder) / "part.png"
            faint = draw_lines(shown, shown.beneath, shown.beneath_params, FAINT, picture)
            bold = draw_lines(shown, (Path(name).name,), shown.params, BOLD, picture)
            both = np.minimum(faint, bold)
            sheet.save(np.round(both * (GREYS - 1)) / (GREYS - 1), options.folder / f"{name}.png")


def open_model(model):
    if model.startswith(pages.LESSON):
        bpy.ops.wm.read_homefile(use_empty=True)
        lessons.build(model.removeprefix(pages.LESSON))
    else:
        draw.open_scene(str(SHARED / "models" / model) if model.endswith(".obj") else model)


def draw_lines(shown, lines, params, pen, picture):
    """(H, W) of some lines of the model, drawn with one pen."""
    scene = bpy.context.scene
    chosen = ["--size", pages.SIZE, "--style", "plain", "--lines", ",".join(lines), *params, "-o", str(picture)]
    options = draw_options.parse([*shown.camera, *chosen])
    draw.set_size(scene, options)
    draw.set_camera(scene, options)
    draw.set_drawing(scene, options)
    draw.set_output(scene, options)
    for name, value in pen.items():
        setattr(scene.fovea, name, value)
    draw.still(scene, picture)
    return sheet.grey(picture)


if __name__ == "__main__":
    try:
        main(sys.argv[sys.argv.index("--") + 1 :])
    except (ValueError, RuntimeError) as error:  # what the user can mend; anything else keeps its traceback
        sys.exit(f"Error: {str(error).removeprefix('Error: ').strip()}")
