# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawn lines of one or more frames as strokes of Grease Pencil.

A baked object has a layer per line set, and one per line set with hidden lines. Each baked stroke carries the id of its
path in the attribute PATH, which is 0 for strokes drawn by hand: baking again replaces those that carry one, in the
frames that are baked, and leaves all else of the object as it is."""

from dataclasses import dataclass

import bpy
import numpy as np

from ..scene import pencils
from ..scene.problem import CannotDraw
from . import pencil_frames

PATH = "path_id"  # attribute of strokes: the two halves of the 64 bits
BAKED = "fovea_baked"  # custom property of Grease Pencil that was baked
PEN, COLOR = "fovea_pen", "fovea_color"  # custom properties of its materials: whose they are, and their pen's color
LEAST_SCALE = 1e-9  # smallest |determinant| of an object's axes
OTHER = 1e-4  # difference from which on a color is another one


@dataclass(frozen=True)
class Layer:
    """What one layer shows of DrawnLines."""

    name: str
    line_set: int
    hidden: bool
    pens: range  # indices into the style's `pens()`

    def has(self, lines):
        """(R,) bool."""
        return (lines.line_set == self.line_set) & ((lines.invisibility > 0) == self.hidden)

    def materials(self):
        """The names of its pens' materials."""
        return [self.name if len(self.pens) == 1 else f"{self.name} {i + 1}" for i in range(len(self.pens))]


def layers_of(style):
    """The Layers of a Style, the lowest first: as in pictures, hidden lines lie below all visible ones."""
    hidden, visible, pen = [], [], len(style.line_sets)
    for i, line_set in enumerate(style.line_sets):
        name = line_set.name.title()
        name = name if all(layer.name != name for layer in visible) else f"{name} {i + 1}"
        visible.append(Layer(name, i, False, range(i, i + 1)))
        if line_set.hidden:
            hidden.append(Layer(f"{name} Hidden", i, True, range(pen, pen + len(line_set.hidden))))
        pen += len(line_set.hidden)
    return [*hidden, *visible]


def found_in(scene):
    """The object of a scene that strokes were baked to; None if there is none."""
    pencils.need("bake with the type Mesh")
    baked = (obj for obj in scene.objects if obj.type == "GREASEPENCIL" and BAKED in obj.data)
    return next(baked, None)


def new_object(name):
    """An object without strokes, not yet linked to a collection."""
    data = pencils.kept().new(name)
    data[BAKED] = True
    obj = bpy.data.objects.new(name, data)
    obj.use_grease_pencil_lights = False  # colors are the pens'
    return obj


def bake(obj, frames, span, style):
    """Writes {frame number: DrawnLines} into an object, for a Style. `span`: the first and last frame that they stand
    for, after which the object shows what it showed before; None: one frame, which stands until the next key."""
    data, keys, to_object = obj.data, sorted(frames), _to_object(obj)
    wanted = [layer for layer in layers_of(style) if any(layer.has(lines).any() for lines in frames.values())]
    shown = {layer.name: data.layers.get(layer.name) or _new_layer(data, layer.name) for layer in wanted}
    for layer in data.layers:
        given = keys if layer.name in shown else keys[:1]
        around = span or (keys[0], keys[0])
        pencil_frames.clear(layer, PATH, given, around, always=layer.name in shown, ends=span is not None)
    for layer in wanted:
        materials = _materials(data, layer, style.pens())
        for number, lines in frames.items():
            if (chosen := layer.has(lines)).any():
                drawing = shown[layer.name].get_frame_at(number).drawing
                pencil_frames.append(drawing, *_strokes(lines, chosen, to_object, layer, materials))


def _to_object(obj):
    matrix = np.array(obj.matrix_world, np.float64)
    if not abs(np.linalg.det(matrix[:3, :3])) > LEAST_SCALE:
        raise CannotDraw(f"'{obj.name}' is scaled to 0: clear its scale, or bake to a new object")
    return np.linalg.inv(matrix)


def _new_layer(data, name):
    layer = data.layers.new(name, set_active=False)
    layer.use_lights = False
    return layer


def _materials(data, layer, pens):
    """Indices into an object's materials, and colors (P, 3), of the pens of a layer. A material that is there already
    is taken, and where somebody has given it another color it keeps that."""
    found = []
    for name, pen in zip(layer.materials(), layer.pens):
        owners = [material.get(PEN) if material else None for material in data.materials]
        if name not in owners:
            data.materials.append(_material(name))
            owners.append(name)
        material, color = data.materials[owners.index(name)], pens[pen].color
        if COLOR not in material or np.allclose(material.grease_pencil.color[:3], material[COLOR], atol=OTHER):
            material.grease_pencil.color = (*color, 1.0)
        material[COLOR] = color
        found.append(owners.index(name))
    return np.array(found, np.int32), np.array([pens[pen].color for pen in layer.pens], np.float32)


def _material(name):
    material = bpy.data.materials.new(name)
    bpy.data.materials.create_gpencil_data(material)
    material[PEN] = name
    return material


def _strokes(lines, chosen, to_object, layer, materials):
    """Sizes, and attributes of points and of strokes as `pencil_frames.append` takes them, of some of DrawnLines. The
    last point of a closed line, which repeats the first, is left out."""
    size, indices = np.diff(lines.offsets), lines.pen[chosen] - layer.pens.start
    last = np.zeros(len(lines.points), bool)
    last[lines.offsets[1:][lines.closed] - 1] = True
    at, sizes = np.repeat(chosen, size) & ~last, (size - lines.closed)[chosen]
    scale = np.float32(abs(np.linalg.det(to_object[:3, :3])) ** (1 / 3))
    points = lines.points[at].astype(np.float64) @ to_object[:3, :3].T + to_object[:3, 3]
    of_points = {
        ("position", "FLOAT_VECTOR"): points.astype(np.float32),
        ("radius", "FLOAT"): lines.radius[at] * scale,
        ("opacity", "FLOAT"): lines.opacity[at],
        ("strength", "FLOAT"): lines.strength[at],
        ("vertex_color", "FLOAT_COLOR"): _colors(lines.color[at], materials[1][indices], sizes),
    }
    of_strokes = {
        ("cyclic", "BOOLEAN"): lines.closed[chosen],
        ("material_index", "INT"): materials[0][indices],
        (PATH, "INT32_2D"): lines.path_id[chosen].view(np.int32).reshape(-1, 2),
    }
    return sizes, of_points, of_strokes


def _colors(color, own, sizes):
    """(M, 4) colors that cover those of the materials, (strokes, 3), along strokes that have another one anywhere;
    elsewhere alpha 0, so that materials color their strokes."""
    stroke = np.repeat(np.arange(len(sizes)), sizes)
    other = np.abs(color - own[stroke]).max(axis=1) > OTHER
    changed = np.bincount(stroke[other], minlength=len(sizes)) > 0
    return np.column_stack([color, changed[stroke].astype(np.float32)])
