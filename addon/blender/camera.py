"""Cameras as the pipeline takes them: a world-to-view and a view-to-clip matrix, in float64, and the drawn region."""

import numpy as np

from ..stages import REFERENCE_HEIGHT, View
from .problem import CannotDraw



def of_render(engine, depsgraph):
    """The View of a final render, border and resolution percentage included."""
    camera = _checked(engine.camera_override or depsgraph.scene.camera).evaluated_get(depsgraph)
    return _of_frame(camera, engine_matrix(engine, camera), depsgraph, engine.resolution_x, engine.resolution_y)


def of_scene(depsgraph, camera=None):
    """The View of what a final render would show from a camera, the scene's where none is named."""
    render = depsgraph.scene.render
    camera = _checked(camera or depsgraph.scene.camera).evaluated_get(depsgraph)
    size = (render.resolution_x, render.resolution_y)
    width, height = (side * render.resolution_percentage // 100 for side in size)
    return _of_frame(camera, camera.matrix_world.normalized(), depsgraph, width, height)


def _of_frame(camera, camera_to_world, depsgraph, width, height):
    render = depsgraph.scene.render
    full = camera.calc_matrix_camera(
        depsgraph, x=width, y=height, scale_x=render.pixel_aspect_x, scale_y=render.pixel_aspect_y
    )
    left, bottom, right, top = _border(render, width, height)
    return View(
        world_to_view=np.linalg.inv(np.array(camera_to_world, np.float64)),
        view_to_clip=_crop(width, height, left, bottom, right, top) @ np.array(full, np.float64),
        width=right - left,
        height=top - bottom,
        orthographic=camera.data.type == "ORTHO",
        near_clip=camera.data.clip_start,
        far_clip=camera.data.clip_end,
        reference_scale=height / REFERENCE_HEIGHT,
        frame=(-left, -bottom, width, height),
    )


def engine_matrix(engine, camera):
    """Camera to world without scale, as Blender renders it (for the eye of a stereo pair, if that is rendered)."""
    return engine.camera_model_matrix(camera, use_spherical_stereo=False)


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
        near, far = camera.data.clip_start, camera.data.clip_end
        frame = _frame(camera, depsgraph, view_to_clip, region)
        scale = frame[3] / REFERENCE_HEIGHT
    if orthographic:
        world_to_view, view_to_clip, near, far = _in_front(world_to_view, view_to_clip)
    return View(world_to_view, view_to_clip, region.width, region.height, bool(orthographic), near, far, scale, frame)


def _checked(camera):
    """The camera, when it is one that can be drawn with."""
    if camera is None or camera.type != "CAMERA":
        raise CannotDraw("The scene has no camera: add one, or make one the scene's active camera")
    if camera.data.type not in {"PERSP", "ORTHO"}:
        raise CannotDraw(
            f"Camera '{camera.name}' is {camera.data.type.lower().replace('pano', 'panoramic')}: "
            "lines can be drawn with perspective and orthographic cameras"
        )
    return camera


def _border(render, width, height):
    """Left, bottom, right, top of the rendered part in pixels of the full frame, rounded as Blender does."""
    if not render.use_border:
        return 0, 0, width, height
    sides = (render.border_min_x, render.border_min_y, render.border_max_x, render.border_max_y)
    return tuple(int(np.float32(side) * np.float32(size)) for side, size in zip(sides, (width, height) * 2))


def _crop(width, height, left, bottom, right, top):
    """(4, 4) matrix on clip space that makes a part of the frame the whole."""
    crop = np.eye(4)
    crop[0, 0], crop[1, 1] = width / (right - left), height / (top - bottom)
    crop[0, 3] = (width - left - right) / (right - left)
    crop[1, 3] = (height - bottom - top) / (top - bottom)
    return crop


def _frame(camera, depsgraph, view_to_clip, region):
    """Left, lower, width and height of the camera's frame in pixels of the viewport that shows it."""
    render = depsgraph.scene.render
    full = camera.calc_matrix_camera(
        depsgraph,
        x=render.resolution_x,
        y=render.resolution_y,
        scale_x=render.pixel_aspect_x,
        scale_y=render.pixel_aspect_y,
    )
    # From the frame to the viewport, both from -1 to 1: a zoom and a shift.
    placed = view_to_clip @ np.linalg.inv(np.array(full, np.float64))
    size, middle = np.diag(placed)[:2] / placed[3, 3], placed[:2, 3] / placed[3, 3]
    region_size = np.array((region.width, region.height))
    lower = (middle - size + 1) / 2 * region_size
    return (*lower, *(size * region_size))


def _in_front(world_to_view, view_to_clip):
    """An orthographic viewport sees behind its eye, too: moves the eye back, so that near becomes positive."""
    depth, offset = view_to_clip[2, 2], view_to_clip[2, 3]
    near, far = (offset + 1.0) / depth, (offset - 1.0) / depth
    start = 1e-3 * (far - near)
    back = np.eye(4)
    back[2, 3] = near - start
    return back @ world_to_view, view_to_clip @ np.linalg.inv(back), start, start + far - near
