# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact sheets: one tile per line definition, with its label below, all from the same camera."""

import math
import tempfile
from pathlib import Path

import bpy
import ending
import numpy as np
import picture
from bl_ext.user_default.fovea.scene import line_kinds
from bl_ext.user_default.fovea.style import style_data
from command import output
from mathutils import Vector

ASPECT = 16 / 9  # target aspect ratio of a sheet
LABEL, LETTERS = 0.12, 0.06  # heights of the strip below a tile and of its letters, as fractions of the tile's height
SHAPE = "contour"  # drawn thinly in every tile, to show the shape
SHAPE_PEN = {"width": 1.6, "color": (0.25, 0.25, 0.25), "taper": 0.0}
PEN = {"width": 5.0, "color": (0.0, 0.0, 0.0), "taper": 0.0}
SUN = (-0.8, 1.0, 1.0)  # towards it, as the camera sees it; where the scene has no light


def render(scene, definitions, path):
    """Writes a sheet of those definitions that the scene's style draws to `path`, an 8-bit gray PNG; without those that
    lack their file."""
    if not any(obj.type == "LIGHT" for obj in scene.objects):
        add_sun(scene)
    held = style_data.own(scene)
    drawn = style_data.drawn_kinds(held)
    shown = [
        definition for definition in definitions if definition["name"] in drawn and not lacks_file(held, definition)
    ]
    if not shown:
        raise ValueError("--sheet: each of these definitions needs a file, as --param learned_line.model=FILE.json")
    size = scene.render.resolution_x, scene.render.resolution_y
    columns = columns_for(len(shown), size)
    rows = -(-len(shown) // columns)
    with tempfile.TemporaryDirectory() as folder:
        tile = Path(folder) / "tile.png"

        def draw(kinds, pen):
            style_data.choose_lines(held, kinds)
            for name, value in pen.items():
                setattr(held.line_sets[-1].pen, name, value)
            picture.render(scene, tile)
            return gray(tile)

        shape = draw({SHAPE}, SHAPE_PEN)
        tiles = [np.minimum(shape, draw({definition["name"]}, PEN)) for definition in shown]
        labels = draw_labels([d["label"] for d in shown], columns, rows, size, tile)
    save(paste(tiles, labels, columns), path)


def add_sun(scene):
    """By which there are light contours and shadows."""
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    seen = Vector(SUN).to_track_quat("Z", "Y")
    sun.rotation_euler = (scene.camera.matrix_world.to_quaternion() @ seen).to_euler()
    scene.collection.objects.link(sun)


def lacks_file(held, definition):
    """Whether no line set of a style names the file that a definition needs."""
    file = definition["file"]
    return file and not any(getattr(s.kinds, line_kinds.property_name(definition, file)) for s in held.line_sets)


def columns_for(count, size):
    """Number of columns for `count` tiles of `size` (w, h) that gives the aspect ratio nearest to ASPECT."""

    def off(columns):
        rows = -(-count // columns)
        return abs(math.log(columns * size[0] / (rows * (size[1] + strip(size)))) - math.log(ASPECT))

    return min(range(1, count + 1), key=off)


def strip(size):
    """Height of the label below a tile of `size`, in pixels."""
    return math.ceil(LABEL * size[1])


def paste(tiles, labels, columns):
    """(H, W) sheet, bottom row first, from tiles (h, w) and labels (rows, strip, W); all optionally with channels."""
    blank = np.ones_like(tiles[0])
    bands = []
    for row, label in enumerate(labels):
        line = tiles[row * columns : (row + 1) * columns]
        line += [blank] * (columns - len(line))
        bands += [np.hstack(line), label]
    return np.vstack(bands[::-1])


def draw_labels(labels, columns, rows, size, path):
    """(rows, strip, columns * width): the labels of each row of tiles. They are rendered with Fovea, from the alpha of
    Blender text objects that are holdouts."""
    wide, high = columns * size[0], strip(size)
    scene = bpy.data.scenes.new("Labels")
    for number, label in enumerate(labels):
        text = bpy.data.curves.new(label, "FONT")
        text.body, text.size, text.align_x, text.align_y = label, LETTERS * size[1], "CENTER", "CENTER"
        written = bpy.data.objects.new(label, text)
        row, column = divmod(number, columns)
        written.location = ((column + 0.5) * size[0], (rows - row - 0.5) * high, 0)
        written.is_holdout = True
        scene.collection.objects.link(written)
    _look_down(scene, wide, rows * high)
    style_data.own(scene).paper.color = (1, 1, 1)
    scene.render.image_settings.file_format, scene.render.image_settings.color_mode = "PNG", "RGBA"
    picture.render(scene, path)
    paper = picture.pixels(path)[..., 3].reshape(rows, high, 2, wide, 2).mean(axis=(2, 4))
    bpy.data.scenes.remove(scene)
    return paper[::-1] ** (1 / 2.2)  # gamma-encoded, like the tiles


def _look_down(scene, width, height):
    """Adds an orthographic camera that sees the rectangle from the origin to (width, height) at 2 pixels per unit."""
    data = bpy.data.cameras.new("Labels")
    data.type, data.ortho_scale = "ORTHO", max(width, height)
    camera = bpy.data.objects.new("Labels", data)
    camera.location = (width / 2, height / 2, 1)
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.engine = "FOVEA"
    scene.render.resolution_x, scene.render.resolution_y = 2 * width, 2 * height


def gray(path):
    return picture.pixels(path)[..., :3].mean(axis=2)


def save(sheet, path, quality=70):
    """Saves an (H, W) sheet as an 8-bit gray PNG, an (H, W, 3) sheet as a JPEG, without color conversion."""
    gray = sheet.ndim == 2
    colors = np.repeat(sheet[..., None], 3, axis=2) if gray else sheet
    image = bpy.data.images.new("Sheet", sheet.shape[1], sheet.shape[0])
    image.colorspace_settings.name = "Non-Color"
    opaque = np.concatenate((colors, np.ones_like(colors[..., :1])), axis=2)
    image.pixels.foreach_set(opaque.astype(np.float32).ravel())
    scene = bpy.data.scenes.new("Sheet")
    scene.view_settings.view_transform = "Raw"
    stored = scene.render.image_settings
    if gray:
        stored.file_format, stored.color_mode, stored.color_depth, stored.compression = "PNG", "BW", "8", 100
    else:
        stored.file_format, stored.color_mode, stored.quality = "JPEG", "RGB", quality
    with output.written(path, picture.is_whole) as fresh:
        image.save_render(str(fresh), scene=scene)
    ending.announce(path)
    bpy.data.scenes.remove(scene)
    bpy.data.images.remove(image)
