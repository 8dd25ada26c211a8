# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn in an SVG file: the paths and shapes that show against its ground."""

import re
import xml.etree.ElementTree as xml
from dataclasses import dataclass

import numpy as np

from . import paper_scale

UNITS = {"": 1.0, "px": 1.0, "mm": 96 / 25.4, "cm": 96 / 2.54, "in": 96.0, "pt": 96 / 72, "pc": 16.0}  # in pixels
NOT_DRAWN = "defs", "clipPath", "mask", "symbol", "marker", "pattern", "metadata"
INHERITED = "fill", "stroke", "visibility"
GROUND = 0.5  # share of the page from which on an area is its ground
CONTRAST = 10 / 255  # of what shows
NAMED = {"white": 1.0}  # luminance; other names count as dark
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"


@dataclass(frozen=True)
class SvgDrawing:
    """N paths. `size`: (width, height) of the page in CSS pixels; `millimeters`: on paper, None if it does not say."""

    size: tuple
    millimeters: tuple | None
    data: list  # of path data, as SVG has it
    transforms: np.ndarray  # (N, 6), to pixels of the page
    is_filled: list  # areas, else lines


def read(text):
    """The SvgDrawing of a file's bytes. ValueError in a sentence if it is none."""
    try:
        root = xml.fromstring(text)
    except xml.ParseError as error:
        raise ValueError(f"it is no SVG file ({error})") from error
    if _tag(root) != "svg":
        raise ValueError("it is no SVG file")
    size, matrix = _page(root)
    shapes = list(_shapes(root, matrix, {}, _classes(root)))
    ground = 1.0
    drawn = []
    for data, transform, look, area in shapes:
        fill, stroke = _luminance(look.get("fill", "black")), _luminance(look.get("stroke", "none"))
        if stroke is None and fill is not None and area * _scale(transform) >= GROUND * size[0] * size[1]:
            ground, drawn = fill, []  # covers what is below
        elif stroke is not None and abs(stroke - ground) > CONTRAST:
            drawn.append((data, transform, False))
        elif stroke is None and fill is not None and abs(fill - ground) > CONTRAST:
            drawn.append((data, transform, True))
    data, transforms, is_filled = zip(*drawn) if drawn else ((), (), ())
    rows = np.array([m[:2].T.ravel() for m in transforms]).reshape(-1, 6)
    return SvgDrawing(size, paper_scale.of_svg(root, size), list(data), rows, list(is_filled))


def _page(root):
    """((width, height) in pixels, matrix (3, 3) from the coordinates of its shapes)."""
    box = [float(n) for n in re.findall(NUMBER, root.get("viewBox", ""))]
    box = box if len(box) == 4 and min(box[2:]) > 0 else None
    size = tuple(_length(root.get(name), of) for name, of in zip(("width", "height"), box[2:] if box else (None, None)))
    if None in size or not 0 < min(size) <= max(size) < 1e6:
        raise ValueError("its page has no size: give it a width and a height, or a viewBox")
    low, inside = (np.array(box[:2]), np.array(box[2:])) if box else (np.zeros(2), np.array(size))
    scale = min(np.array(size) / inside)  # in the middle, as SVG has it unless told otherwise
    matrix = np.diag([scale, scale, 1.0])
    matrix[:2, 2] = (np.array(size) - scale * inside) / 2 - scale * low
    return size, matrix


def _length(text, otherwise):
    found = re.fullmatch(rf"\s*({NUMBER})\s*(\w*)\s*", text or "")
    return float(found[1]) * UNITS[found[2]] if found and found[2] in UNITS else otherwise


def _classes(root):
    """{class: {property: value}} of the rules of style sheets that are for classes."""
    sheets = "".join(element.text or "" for element in root.iter() if _tag(element) == "style")
    rules = re.findall(r"([^{}]+)\{([^}]*)\}", sheets)
    return {name: _declared(body) for names, body in rules for name in re.findall(r"\.([\w-]+)", names)}


def _declared(text):
    pairs = (part.partition(":") for part in text.split(";"))
    return {name.strip(): value.strip() for name, _, value in pairs if value}


def _shapes(element, matrix, look, classes):
    """(path data, matrix, look, area of its box) of each shape below an element, from below."""
    if _tag(element) in NOT_DRAWN:
        return
    own = dict(element.attrib)
    for name in own.get("class", "").split():
        own |= classes.get(name, {})
    own |= _declared(own.get("style", ""))
    if own.get("display") == "none" or any(own.get(name) in ("0", "0.0") for name in ("opacity", "stroke-opacity")):
        return
    look = look | {name: own[name] for name in INHERITED if own.get(name, "inherit") != "inherit"}
    matrix = matrix @ _transform(own.get("transform", ""))
    data = _data(element)
    if data and look.get("visibility", "visible") == "visible":
        yield data, matrix, look, _area(element)
    for child in element:
        yield from _shapes(child, matrix, look, classes)


def _data(element):
    """Path data of a shape; "" of what is none."""
    at, tag = element.attrib, _tag(element)

    def number(name):
        return _length(at.get(name), 0.0)

    if tag == "path":
        return at.get("d", "")
    if tag == "line":
        return f"M{number('x1')} {number('y1')} {number('x2')} {number('y2')}"
    if tag in ("polyline", "polygon"):
        return f"M{at.get('points', '')}{'z' if tag == 'polygon' else ''}"
    if tag == "rect":
        return f"M{number('x')} {number('y')}h{number('width')}v{number('height')}h{-number('width')}z"
    if tag in ("circle", "ellipse"):
        rx, ry = (number("r"),) * 2 if tag == "circle" else (number("rx"), number("ry"))
        half = f"a{rx} {ry} 0 1 0"
        return f"M{number('cx') - rx} {number('cy')}{half} {2 * rx} 0{half} {-2 * rx} 0z"
    return ""


def _area(element):
    """Of a rectangle; 0: of others, which are no ground."""
    if _tag(element) != "rect":
        return 0.0
    return _length(element.get("width"), 0.0) * _length(element.get("height"), 0.0)


def _transform(text):
    """Matrix (3, 3) of a transform attribute."""
    matrix = np.eye(3)
    for name, arguments in re.findall(r"(\w+)\s*\(([^)]*)\)", text):
        n = [float(each) for each in re.findall(NUMBER, arguments)]
        matrix = matrix @ _part(name, n)
    return matrix


def _part(name, n):
    part = np.eye(3)
    if name == "matrix" and len(n) == 6:
        part[:2] = np.array(n).reshape(3, 2).T
    elif name == "translate" and n:
        part[:2, 2] = n[0], n[1] if len(n) > 1 else 0.0
    elif name == "scale" and n:
        part[0, 0], part[1, 1] = n[0], n[-1]
    elif name == "rotate" and n:
        c, s = np.cos(np.radians(n[0])), np.sin(np.radians(n[0]))
        part[:2, :2] = [[c, -s], [s, c]]
        if len(n) == 3:
            part[:2, 2] = np.array(n[1:]) - part[:2, :2] @ n[1:]
    elif name in ("skewX", "skewY") and n:
        part[(0, 1) if name == "skewX" else (1, 0)] = np.tan(np.radians(n[0]))
    return part


def _scale(matrix):
    return abs(np.linalg.det(matrix[:2, :2]))


def _luminance(color):
    """In [0, 1]; None: nothing is painted."""
    color = color.strip().lower()
    if color in ("none", "transparent"):
        return None
    digits = re.fullmatch(r"#([\da-f]{3}|[\da-f]{6})", color)
    if digits:
        step = len(digits[1]) // 3
        values = [int(digits[1][i * step : (i + 1) * step] * (2 // step), 16) / 255 for i in range(3)]
    elif color.startswith("rgb("):
        found = re.findall(rf"({NUMBER})(%?)", color)[:3]
        values = [float(number) / (100 if percent else 255) for number, percent in found]
    else:
        return NAMED.get(color, 0.0)
    return float(np.dot(values, (0.2126, 0.7152, 0.0722))) if len(values) == 3 else 0.0


def _tag(element):
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""
