# SPDX-License-Identifier: GPL-3.0-or-later
"""Response curves of transfer functions: Float Curve nodes in a style's node tree, named by part and effect. The part
of a pen is a name of its own, given with its first curve; pens without curves have no nodes.

Fovea interpolates the points by a monotone cubic, as Blender does for handles of type Auto Clamped. Style files cannot
store other handle types (Vector, or Auto, which overshoots): there the curve's points are kept, and points are inserted
until the monotone cubic matches Blender's curve. Two points are a straight line in both.
"""

import itertools
import math
import re

from .. import style
from ..curve_fit import fewest
from ..scene.property_kinds import neat

STRAIGHT = ((0.0, 0.0), (1.0, 1.0))
PLACES = 256  # samples of a curve with other handle types, the resolution of Blender's own table
BESIDE = 1 / 2048  # distance along x of the points on both sides of a corner that keep it sharp
APART = 1e-6  # points at most this far apart along x are merged


def node_name(part, effect):
    """Name of the node of an effect's curve, for example "effects.width"."""
    return f"{part}.{effect}"


def _node(tree, part, effect):
    """The node of an effect's curve, or None."""
    node = tree.nodes.get(node_name(part, effect))
    return node if node and node.bl_idname == "ShaderNodeFloatCurve" else None


def read(tree, part, effect):
    """The curve of a Transfer: (x, y) points in [0, 1]; () for a straight line or a missing node."""
    node = _node(tree, part, effect)
    return points_of(node.mapping) if node else ()


def points_of(mapping):
    """The (x, y) points in [0, 1] of a curve mapping's first curve; () for a straight line."""
    curve = mapping.curves[0]
    if len(curve.points) > 2 and any(point.handle_type != "AUTO_CLAMPED" for point in curve.points):
        points = _fitted(mapping, curve)
    else:
        points = [(point.location[0], point.location[1]) for point in curve.points]
    found = []
    for x, y in sorted((neat(_share(x)), neat(_share(y))) for x, y in points):
        if not found or x > found[-1][0] + APART:
            found.append((x, y))
    found = tuple(found[: style.MOST_CURVE_POINTS])
    return () if found == STRAIGHT else found


def write(tree, part, effect, points):
    """Writes points to the node of an effect's curve, created if missing. A single point becomes a constant curve."""
    node = _node(tree, part, effect)
    if node is None:
        node = tree.nodes.new("ShaderNodeFloatCurve")
        node.name = node.label = node_name(part, effect)
        node.location = (280 * (len(tree.nodes) - 1), 0)
    points = points or STRAIGHT
    if len(points) == 1:
        points = ((0.0, points[0][1]), (1.0, points[0][1]))
    mapping = node.mapping
    curve = mapping.curves[0]
    mapping.extend = "HORIZONTAL"
    while len(curve.points) > 2:
        curve.points.remove(curve.points[1])
    curve.points[0].location, curve.points[1].location = (-1.0, 0.0), (2.0, 0.0)
    for x, y in points[1:-1]:
        curve.points.new(x, y)
    # The end points are placed last, because Blender keeps points sorted by x.
    curve.points[0].location, curve.points[len(curve.points) - 1].location = points[0], points[-1]
    for point in curve.points:
        point.handle_type = "AUTO_CLAMPED"
    mapping.update()


def pens(held):
    """Yields the properties of all pens of a style."""
    for line_set in held.line_sets:
        for drawn in (line_set, *line_set.hidden):
            yield from (drawn.pen, drawn.pen_away)


def write_of_pen(pen, effect, points):
    """Writes the curve of one of a pen's effects; a straight line needs a node only where there is one. Library
    overrides, which cannot keep nodes of their own, have straight lines."""
    tree = pen.id_data
    if (points and not tree.override_library) or _node(tree, pen.curves, effect):
        add_to_pen(pen, effect, points)


def add_to_pen(pen, effect, points=()):
    """Writes the curve of one of a pen's effects to a node of its own."""
    tree = pen.id_data
    if not pen.curves:
        taken = {other.curves for other in pens(tree.fovea)}
        pen.curves = next(name for name in map("pen{}".format, itertools.count(1)) if name not in taken)
    write(tree, pen.curves, effect, points)


def drop_unused(tree):
    """Removes the curves of pens that are gone."""
    used = {pen.curves for pen in pens(tree.fovea)}
    for node in list(tree.nodes):
        part = node.name.partition(".")[0]
        if re.fullmatch(r"pen\d+", part) and part not in used:
            tree.nodes.remove(node)


def _fitted(mapping, curve):
    """Points whose monotone cubic matches Blender's curve within curve_fit.TOLERANCE, if few enough points suffice."""
    mapping.initialize()
    own = {point.location[0]: point for point in curve.points if 0 <= point.location[0] <= 1}
    found = {x: point.location[1] for x, point in own.items()}
    for x in (i / PLACES for i in range(PLACES + 1)):
        if all(abs(x - other) > 1.5 * BESIDE for other in own):
            found[x] = mapping.evaluate(curve, x)
    for x, point in own.items():
        for side in (-2 / PLACES, 2 / PLACES):
            if point.handle_type == "VECTOR" and 0 <= x + side <= 1:
                slope = (mapping.evaluate(curve, x + side) - point.location[1]) / abs(side)
                found[x + math.copysign(BESIDE, side)] = point.location[1] + slope * BESIDE
    points = tuple((x, _share(found[x])) for x in sorted(found))
    kept = tuple(i for i, (x, _) in enumerate(points) if x in own)
    corners = tuple(i for i in kept if own[points[i][0]].handle_type == "VECTOR")
    return [points[i] for i in fewest(points, kept[: style.MOST_CURVE_POINTS], corners, style.MOST_CURVE_POINTS)]


def _share(value):
    return min(max(value, 0.0), 1.0)
