# SPDX-License-Identifier: GPL-3.0-or-later
"""Plain OpenGL lines with a depth test and no style: the baseline cost of drawing lines.

Everything is in vertex buffers from the first frame on, except lines that change with the view."""

import gpu
import numpy as np
from bl_ext.user_default.fovea import native
from bl_ext.user_default.fovea.gpu.program import vertex_buffer
from bl_ext.user_default.fovea.gpu.texture import Target
from mathutils import Matrix

# Depth offset of lines towards the eye, against z-fighting with their own surface.
NEARER = np.diag((1.0, 1.0, 1.0 - 1e-4, 1.0))


class PlainLines:
    def __init__(self, placed, object_to_world):
        self.shader = gpu.shader.from_builtin("UNIFORM_COLOR")
        self.surfaces = []
        self.object_to_world = object_to_world
        for placement, matrix in enumerate(object_to_world):
            positions = native.load().DepthCorners(placed.surface(placement)).positions
            if len(positions):
                self.surfaces.append(batch("TRIS", world(positions, matrix)))
        self.lines, self.drawn = None, None

    def upload(self, paths):
        """Uploads the vertices of the lines, if the paths have changed."""
        if self.drawn is not None and np.array_equal(self.drawn, paths.ids):
            return
        self.drawn = np.array(paths.ids)
        point_counts = np.diff(paths.offsets)
        placement = np.repeat(paths.placement, point_counts)
        points = np.empty_like(paths.points_obj)
        for index, matrix in enumerate(self.object_to_world):
            points[placement == index] = world(paths.points_obj[placement == index], matrix)
        starts = np.ones(len(points), bool)
        starts[paths.offsets[1:] - 1] = False  # the last point of a path starts no segment
        first = np.flatnonzero(starts)
        self.lines = batch("LINES", points[np.stack((first, first + 1), axis=1).ravel()])

    def draw(self, world_to_clip, width, height):
        """Draws the picture and waits for the GPU; returns its Target."""
        target = Target(width, height, "RGBA8", depth=True)
        with target.bind() as framebuffer, gpu.matrix.push_pop(), gpu.matrix.push_pop_projection():
            framebuffer.clear(color=(1.0, 1.0, 1.0, 1.0), depth=1.0)
            gpu.state.depth_test_set("LESS_EQUAL")
            gpu.state.depth_mask_set(True)
            gpu.matrix.load_matrix(Matrix.Identity(4))
            gpu.matrix.load_projection_matrix(Matrix(world_to_clip))
            self._paint((1.0, 1.0, 1.0, 1.0), self.surfaces)
            gpu.matrix.load_projection_matrix(Matrix(NEARER @ world_to_clip))
            self._paint((0.0, 0.0, 0.0, 1.0), [self.lines])
        target.wait()
        return target

    def _paint(self, color, batches):
        self.shader.bind()
        self.shader.uniform_float("color", color)
        for each in batches:
            each.draw(self.shader)


def world(points, matrix):
    return np.ascontiguousarray(points @ matrix[:3, :3].T + matrix[:3, 3], np.float32)


def batch(kind, positions):
    return gpu.types.GPUBatch(type=kind, buf=vertex_buffer({"pos": positions}))
