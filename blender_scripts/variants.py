# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea figures`: one of the sheets of command/variants.py, as a JPEG of its tiles."""

import argparse
import sys
import tempfile
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))

import draw
import drawing_settings
import ending
import picture
import scene_source
import sheet
from command import draw_options, variants


def main(words):
    parser = argparse.ArgumentParser()
    parser.add_argument("sheet", choices=variants.SHEETS)
    parser.add_argument("output", type=Path, help="OUT.jpg")
    options = parser.parse_args(words)
    scene_name, tiles = variants.SHEETS[options.sheet]
    size = {1: (1280, 720), 2: (960, 540)}.get(len(tiles), (480, 270))
    columns = min(sheet.columns_for(len(tiles), size), 3 if len(tiles) == 9 else 4)
    scene_source.open_scene(scene_name)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "tile.png"
        drawn = [draw_tile(scene_name, tile, size, path) for _, tile in tiles]
        if len(tiles) > 1:
            labels = sheet.draw_labels([label for label, _ in tiles], columns, -(-len(tiles) // columns), size, path)
            drawn = [sheet.paste(drawn, np.repeat(labels[..., None], 3, axis=3), columns)]
    sheet.save(drawn[0], options.output)


def draw_tile(scene_name, words, size, path):
    """(h, w, 3) picture of the scene with the options `words` of `fovea draw`, supersampled by 2."""
    scene = bpy.context.scene
    width, height = 2 * size[0], 2 * size[1]
    options = draw_options.parse([scene_name, *words, "--size", f"{width}x{height}", "-o", str(path)])
    draw.set_size(scene, options)
    draw.set_camera(scene, options)
    scene.fovea.focus_model = "NONE"
    drawing_settings.set_drawing(scene, options)
    draw.set_output(scene, options)
    picture.render(scene, path)
    return picture.pixels(path)[..., :3].reshape(size[1], 2, size[0], 2, 3).mean(axis=(1, 3))


if __name__ == "__main__":
    ending.run(main)
