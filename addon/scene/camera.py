# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts Blender's cameras to Views: world-to-view and view-to-clip matrices in float64, and the drawn region.

As in Blender, an object of any type may be the scene's camera: `calc_matrix_camera` returns a projection for it, too (a
spot light's has the width of its cone)."""

import numpy as np

from ..stages import REFERENCE_HEIGHT, View
from . import followed
from .problem import CannotDraw

FARTHEST = 1e29  # largest coordinate of a camera
LEAST_VOLUME = 1e-6  # smallest |determinant| accepted for a camera's normalized axes
OBJECT_CLIP = 0.1, 100.0  # near and far of Blender's projection for objects that are not cameras


def of_render(engine, depsgraph):
    """The View of a final render, including its border and resolution percentage."""
    camera = chosen(engine, depsgraph).evaluated_get(depsgraph)
    size = engine.resolution_x, engine.resolution_y
    return _of_frame(camera, engine_matrix(engine, camera), depsgraph, *size, _shift(engine, camera))


def of_scene(depsgraph, camera=None):
    """The View of a final render from `camera`; None: the scene's."""
    render = followed.of(depsgraph.scene).render
    camera = _checked(camera or followed.camera(depsgraph.scene)).evaluated_get(depsgraph)
    return _of_frame(camera, camera.matrix_world.normalized(), depsgraph, *frame_size(render))


def frame_size(render):
    """(width, height) in pixels of a picture of a scene, by its render settings."""
    return tuple(side * render.resolution_percentage // 100 for side in (render.resolution_x, render.resolution_y))


def _of_frame(camera, camera_to_world, depsgraph, width, height, shift=0.0):
    near, far = _clip_distances(camera, OBJECT_CLIP)
    full = _shifted(_projection(camera, depsgraph, width, height), camera, shift)
    left, bottom, right, top = _border(followed.of(depsgraph.scene).render, width, height)
    return View(
        world_to_view=_world_to_view(camera, camera_to_world),
        view_to_clip=_crop(width, height, left, bottom, right, top) @ full,
        width=right - left,
        height=top - bottom,
        orthographic=bool(full[3, 3] != 0.0),
        near_clip=near,
        far_clip=far,
        reference_scale=height / REFERENCE_HEIGHT,
        frame=(-left, -bottom, width, height),
    )


def chosen(engine, depsgraph):
    """The camera object of a final render."""
    if followed.follows(depsgraph.scene):
        return _checked(followed.camera(depsgraph.scene))
    return _checked(engine.camera_override or depsgraph.scene.camera)


def engine_matrix(engine, camera):
    """Camera-to-world matrix without scale, as Blender renders it; of the eye being rendered in stereo."""
    return engine.camera_model_matrix(camera, use_spherical_stereo=False)


def _shift(engine, camera):
    """What the lens of the eye being rendered in stereo is shifted to the side, beside the camera's own shift."""
    if camera.type != "CAMERA":
        return 0.0
    return engine.camera_shift_x(camera, use_spherical_stereo=False) - camera.data.shift_x


def _shifted(full, camera, shift):
    """A projection whose lens is shifted further to the side, in sizes of the sensor."""
    if shift and full[3, 3]:
        full[0, 3] -= full[0, 0] * shift * camera.data.ortho_scale
    elif shift:
        data = camera.data
        sensor = data.sensor_height if data.sensor_fit == "VERTICAL" else data.sensor_width
        full[0, 2] += full[0, 0] * shift * sensor / data.lens
    return full


def in_frame(depsgraph, at):
    """Projects world coordinates into the scene camera's frame: (x, y), 0 to 1 from the lower left corner."""
    camera, render = depsgraph.scene.camera.evaluated_get(depsgraph), depsgraph.scene.render
    full = _projection(camera, depsgraph, render.resolution_x, render.resolution_y)
    clip = full @ _world_to_view(camera, camera.matrix_world.normalized()) @ (*at, 1.0)
    return (clip[:2] / clip[3] + 1.0) / 2.0


def of_region(context, depsgraph):
    """The View of a 3D viewport."""
    region, region_3d, space = context.region, context.region_data, context.space_data
    world_to_view = np.array(region_3d.view_matrix, np.float64)
    view_to_clip = np.array(region_3d.window_matrix, np.float64)
    orthographic = view_to_clip[3, 3] != 0.0
    near, far = space.clip_start, space.clip_end
    scale, frame = region.height / REFERENCE_HEIGHT, (0, 0, region.width, region.height)
    if region_3d.view_perspective == "CAMERA":
        camera = _checked(space.camera or depsgraph.scene.camera).evaluated_get(depsgraph)
        _world_to_view(camera, camera.matrix_world.normalized())  # raises if singular; view_matrix would be invalid
        near, far = _clip_distances(camera, (near, far))
        frame = _frame(camera, depsgraph, view_to_clip, region)
        scale = frame[3] / REFERENCE_HEIGHT
    if orthographic:
        world_to_view, view_to_clip, near, far = _in_front(world_to_view, view_to_clip)
    return View(world_to_view, view_to_clip, region.width, region.height, bool(orthographic), near, far, scale, frame)


def _checked(camera):
    """The camera. CannotDraw if it is None or its type is not supported."""
    if camera is None:
        raise CannotDraw("The scene has no camera: add one, or make one the scene's active camera")
    if camera.type == "CAMERA" and camera.data.type not in {"PERSP", "ORTHO"}:
        raise CannotDraw(
            f"Camera '{camera.name}' is {camera.data.type.lower().replace('pano', 'panoramic')}: "
            "lines can be drawn with perspective and orthographic cameras"
        )
    return camera


def _projection(camera, depsgraph, width, height):
    """(4, 4) view-to-clip matrix of the full frame of width x height pixels. CannotDraw if it is degenerate."""
    render = followed.of(depsgraph.scene).render
    aspect = {"scale_x": render.pixel_aspect_x, "scale_y": render.pixel_aspect_y}
    found = np.array(camera.calc_matrix_camera(depsgraph, x=width, y=height, **aspect), np.float64)
    if not (np.isfinite(found).all() and found[0, 0] and found[1, 1]):
        raise CannotDraw(
            f"Camera '{camera.name}' shows nothing: its focal length, sensor or shift is too large; reset it"
        )
    return found


def _clip_distances(camera, otherwise):
    """(near, far) in scene units; `otherwise`: returned for objects that are not cameras. CannotDraw if near >= far."""
    if camera.type != "CAMERA":
        return otherwise
    near, far = camera.data.clip_start, camera.data.clip_end
    if near >= far:
        raise CannotDraw(
            f"Camera '{camera.name}' sees from a distance of {near:g} up to one of {far:g}, which is nothing: "
            "set its Clip Start below its Clip End"
        )
    return near, far


def _world_to_view(camera, camera_to_world):
    """(4, 4) inverse of a camera-to-world matrix. CannotDraw if it is singular."""
    matrix = np.array(camera_to_world, np.float64)
    # Blender normalizes axes that are no numbers to 0.
    if not (np.isfinite(camera.matrix_world).all() and np.abs(matrix).max() < FARTHEST):
        raise CannotDraw(
            f"Camera '{camera.name}' is nowhere: its location, rotation or scale, or that of its parents, is not a "
            f"number or beyond {FARTHEST:g}; reset them"
        )
    if not abs(np.linalg.det(matrix[:3, :3])) > LEAST_VOLUME:
        raise CannotDraw(
            f"Camera '{camera.name}' looks in no direction, as it is scaled to 0: "
            "clear its scale, or that of its parents"
        )
    return np.linalg.inv(matrix)


def _border(render, width, height):
    """Left, bottom, right, top of the rendered part in pixels of the full frame, rounded as Blender does."""
    if not render.use_border:
        return 0, 0, width, height
    sides = (render.border_min_x, render.border_min_y, render.border_max_x, render.border_max_y)
    return tuple(int(np.float32(side) * np.float32(size)) for side, size in zip(sides, (width, height) * 2))


def _crop(width, height, left, bottom, right, top):
    """(4, 4) matrix on clip space that maps a part of the frame (pixels) to the whole clip range."""
    crop = np.eye(4)
    crop[0, 0], crop[1, 1] = width / (right - left), height / (top - bottom)
    crop[0, 3] = (width - left - right) / (right - left)
    crop[1, 3] = (height - bottom - top) / (top - bottom)
    return crop


def _frame(camera, depsgraph, view_to_clip, region):
    """(left, lower, width, height) of the camera's frame in pixels of the viewport's region."""
    render = depsgraph.scene.render
    full = _projection(camera, depsgraph, render.resolution_x, render.resolution_y)
    # Maps clip space of the frame to that of the viewport: a scale and a translation.
    placed = view_to_clip @ np.linalg.inv(full)
    size, middle = np.diag(placed)[:2] / placed[3, 3], placed[:2, 3] / placed[3, 3]
    region_size = np.array((region.width, region.height))
    lower = (middle - size + 1) / 2 * region_size
    return (*lower, *(size * region_size))


def _in_front(world_to_view, view_to_clip):
    """Moves the eye of an orthographic viewport, whose clip range extends behind it, back so that near is positive.
    Returns (world_to_view, view_to_clip, near, far)."""
    depth, offset = view_to_clip[2, 2], view_to_clip[2, 3]
    near, far = (offset + 1.0) / depth, (offset - 1.0) / depth
    start = 1e-3 * (far - near)
    back = np.eye(4)
    back[2, 3] = near - start
    return back @ world_to_view, view_to_clip @ np.linalg.inv(back), start, start + far - near
