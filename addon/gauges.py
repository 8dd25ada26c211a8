# SPDX-License-Identifier: GPL-3.0-or-later
"""Gauges: discs with a pin on a picture, drawn without perspective, which people turn until they seem to lie on what
they see (Cole 2009, 4.2). Without Blender and the rest of the add-on, because the commands of a checkout compute by it,
too.

Normals are (3,) unit vectors, x to the right, y up, z towards the viewer."""

import math

import numpy as np

PIN = 1.2  # length of a pin of which nothing is foreshortened, in radii
STEEPEST = 88.0  # degrees from the viewer: what a drag of two radii makes
# What is practiced on: half of an ellipsoid with half axes [a, b, c], in pixels of a picture from its upper left, the
# radius and places of gauges on it, and by how many degrees they may be off.
EXAMPLE = {
    "size": (400, 280), "axes": (150, 100, 110), "middle": (200, 140), "radius": 20,
    "places": [(110, 120), (230, 80), (290, 150), (180, 200)], "good": 15,
}  # fmt: skip
_TURN = np.linspace(0, 2 * np.pi, 65)[:, None]


def normal(slant, tilt):
    """(3,) of a gauge that leans `slant` [rad] away from the viewer, to the side of `tilt` [rad] from the x axis."""
    return np.array([math.sin(slant) * math.cos(tilt), math.sin(slant) * math.sin(tilt), math.cos(slant)])


def ellipse(n, radius):
    """(major, minor, angle of the minor axis [rad], pin (2,)) of a gauge's disc with the normal n; the pin, from the
    middle, y up."""
    angle = math.atan2(n[1], n[0])
    return radius, radius * n[2], angle, (PIN * radius * n[0], PIN * radius * n[1])


def lines(n, radius):
    """(disc (k, 2), pin (2, 2)) of a gauge as polylines from its middle, y up."""
    major, minor, angle, pin = ellipse(n, radius)
    narrow, wide = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    return major * np.cos(_TURN) * wide + minor * np.sin(_TURN) * narrow, np.array([(0.0, 0.0), pin])


def dragged(offset, radius):
    """(3,) normal that a pointer makes which is dragged so far (x, y) from the middle, y up."""
    far = min(math.hypot(*offset) / (2 * radius), 1.0)
    return normal(math.asin(far) * STEEPEST / 90, math.atan2(offset[1], offset[0]))


def angles(a, b):
    """Degrees between unit vectors (..., 3)."""
    return np.degrees(np.arccos(np.clip((np.asarray(a) * b).sum(axis=-1), -1, 1)))


def normal_of_example(place):
    """(3,) of the shape that is practiced on, at a place of its picture."""
    a, b, c = EXAMPLE["axes"]
    x, y = place[0] - EXAMPLE["middle"][0], EXAMPLE["middle"][1] - place[1]
    z = c * math.sqrt(max(0.0, 1 - (x / a) ** 2 - (y / b) ** 2))
    n = np.array([x / a**2, y / b**2, z / c**2])
    return n / np.linalg.norm(n)


def anywhere(random):
    """(3,) of a gauge in any direction that it can be set to, each equally likely. `random`: a random.Random."""
    least = math.cos(math.radians(STEEPEST))
    return normal(math.acos(random.uniform(least, 1.0)), random.uniform(0.0, 2 * math.pi))


def sets(count, strings=(), usual=30):
    """How gauges are shared out over sessions: slices of consecutive ones, of nearly equal sizes up to `usual`; then
    two strings for each. `strings`: (first, end) of those at the end of all."""
    count = strings[0][0] if strings else count
    parts = -(-count // usual)
    ends = [round(i * count / parts) for i in range(parts + 1)]
    pairs = [strings[i : i + 2] for i in range(0, len(strings), 2)]
    return [slice(first, end) for first, end in [*zip(ends, ends[1:]), *((pair[0][0], pair[-1][1]) for pair in pairs)]]
