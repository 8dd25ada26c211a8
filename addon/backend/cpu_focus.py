# SPDX-License-Identifier: GPL-3.0-or-later
"""Focus, and what is painted, per sample and per pixel. Each function is one call of the native module, or few."""

import numpy as np

from .. import native


def focus_of(focus, frame):
    """The native Focus of a style's Focus, as a Frame sees it."""
    in_scene, view = focus.model in ("scene", "object"), frame.view
    place = _in_view if in_scene else _in_image
    chosen = focus.points if focus.active() else ()
    points = [(*place(point, view), *_radii(point, view, in_scene)) for point in chosen]
    surfaces = [_surface_of(point.object, frame) for point in chosen] if focus.model == "object" else []
    return native.load().Focus(in_scene, points, focus.combine == "sum", surfaces)


def _surface_of(name, frame):
    """Distance from what a Frame shows of an object, and of what it makes instances of; None where that is nothing."""
    placements = [i for i, names in enumerate(frame.notes.objects) if name in names]
    if not placements:
        return None
    return native.load().SurfaceDistance(frame.scene, frame.view, np.array(placements, np.uint32))


def _in_view(point, view):
    x, y, z, _ = view.world_to_view @ (*point.at, 1.0)
    return x, y, z


def _in_image(point, view):
    left, lower, width, height = view.frame
    return left + point.at[0] * width, lower + (1 - point.at[1]) * height, 0.0


def _radii(point, view, in_scene):
    unit = 1.0 if in_scene else view.frame[3]
    return point.near * unit, point.far * unit


def focus_of_samples(clipped, focus):
    """(samples,) float32 in [0, 1]."""
    return native.load().focus_of_samples(clipped, focus)


def focus_of_pixels(view, distance, focus):
    """(H, W) float32 in [0, 1]; distance (H, W) as of `depth_image`."""
    return native.load().focus_of_pixels(view, distance, focus)


def magnified(image, view):
    """(H, W) values of a View's pixels: of those of an image of the same in fewer pixels, the nearest."""
    sides = (view.height, view.width)
    rows, columns = ((np.arange(new) + 0.5) * old / new for old, new in zip(image.shape, sides))
    return image[np.ix_(rows.astype(np.intp), columns.astype(np.intp))]


def values_on_paths(frame, attribute):
    """(N,) float32 in [0, 1]: what is painted along a Frame's paths; .5 where nothing is."""
    return native.load().values_on_paths(frame.paths, frame.scene, _painted(frame, attribute))


def values_of_samples(clipped, values):
    """(samples,) float32 of values at the points of paths."""
    return native.load().values_of_samples(clipped, values)


def painted_image(frame, attribute, cancel):
    """(H, W) float32 in [0, 1]: what is painted on what each pixel sees; 0 where that is nothing."""
    return native.load().painted_image(frame.tracer, _painted(frame, attribute), cancel)


def _painted(frame, attribute):
    return frame.notes.painted.get(attribute) or [None] * len(frame.scene)


def map_of_samples(frame, image):
    """(samples,) float32 in [0, 1]: luminance of a native ColorTexture over the camera's frame."""
    return native.load().map_of_samples(frame.clipped, frame.view, image)


def distance_of_samples(clipped, near, far):
    """(samples,) float32 in [0, 1]."""
    return native.load().distance_of_samples(clipped, near, far)
