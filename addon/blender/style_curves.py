"""Response curves of transfer functions: Float Curve nodes in a style's node tree, each named by its part and effect.

Fovea joins the points by a monotone cubic, which is what Blender shows of points whose handles are clamped. Of other
handles, as vectors or such as overshoot, what Blender shows is sampled. Two points are a straight line to both.
"""

from ..focus import MOST_CURVE_POINTS
from .property_kinds import neat

STRAIGHT = ((0.0, 0.0), (1.0, 1.0))
APART = 1e-6  # of points along x; nearer ones are one


def node_name(part, effect):
    """"effects.width" is the curve of that effect."""
    return f"{part}.{effect}"


def read(tree, part, effect):
    """A Transfer's curve; straight where the node is missing."""
    node = tree.nodes.get(node_name(part, effect))
    if node is None or node.bl_idname != "ShaderNodeFloatCurve":
        return ()
    mapping = node.mapping
    curve = mapping.curves[0]
    if len(curve.points) > 2 and any(point.handle_type != "AUTO_CLAMPED" for point in curve.points):
        points = _sampled(mapping, curve)
    else:
        points = [(point.location[0], point.location[1]) for point in curve.points]
    found = []
    for x, y in sorted((neat(_share(x)), neat(_share(y))) for x, y in points):
        if not found or x > found[-1][0] + APART:
            found.append((x, y))
    found = tuple(found[:MOST_CURVE_POINTS])
    return () if found == STRAIGHT else found


def write(tree, part, effect, points):
    """Makes the node if need be. A single point holds everywhere, as a pair does."""
    node = tree.nodes.get(node_name(part, effect))
    if node is None or node.bl_idname != "ShaderNodeFloatCurve":
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


def _sampled(mapping, curve):
    mapping.initialize()
    places = [i / (MOST_CURVE_POINTS - 1) for i in range(MOST_CURVE_POINTS)]
    return [(x, mapping.evaluate(curve, x)) for x in places]


def _share(value):
    return min(max(value, 0.0), 1.0)
