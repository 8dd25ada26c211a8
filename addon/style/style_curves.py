# SPDX-License-Identifier: GPL-3.0-or-later
"""Response curves of transfer functions: Float Curve nodes in a style's node tree, each named by its part and effect.

Fovea joins the points by a monotone cubic, which is what Blender shows of points whose handles are clamped. Of others,
as vectors or such as overshoot, style files cannot say the handles: there the curve's points stay, and as many are put
between them as keep what is drawn to what Blender shows. Two points are a straight line to both.
"""

import math

from .. import style
from ..curve_fit import fewest
from ..scene.property_kinds import neat

STRAIGHT = ((0.0, 0.0), (1.0, 1.0))
PLACES = 256  # steps at which a curve with other handles is looked at, as Blender itself does
BESIDE = 1 / 2048  # of a corner, where points to both sides keep it sharp
APART = 1e-6  # of points along x; nearer ones are one


def node_name(part, effect):
    """Of an effect's curve, as "effects.width"."""
    return f"{part}.{effect}"


def _node(tree, part, effect):
    """The node of an effect's curve, or None."""
    node = tree.nodes.get(node_name(part, effect))
    return node if node and node.bl_idname == "ShaderNodeFloatCurve" else None


def read(tree, part, effect):
    """A Transfer's curve; straight where the node is missing."""
    node = _node(tree, part, effect)
    if node is None:
        return ()
    mapping = node.mapping
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
    """Makes the node if need be. A single point holds everywhere, as a pair does."""
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
    # The outermost come last: points are kept in the order of x.
    curve.points[0].location, curve.points[len(curve.points) - 1].location = points[0], points[-1]
    for point in curve.points:
        point.handle_type = "AUTO_CLAMPED"
    mapping.update()


def _fitted(mapping, curve):
    """Points that give back, within curve_fit.TOLERANCE, what Blender shows."""
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
