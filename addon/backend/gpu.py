"""The gpu backend: depth, visibility and strokes as passes of Blender's gpu module. Use it where there is a context."""

import gpu
import numpy as np

from .. import native
from .gpu_program import Programs, draw_triangles, vertex_buffer
from .gpu_texture import ROW_WIDTH, Target, size_limit, upload_row

_BACKGROUND = (0.0, 0.0, 0.0, -1.0)  # depth, slopes, facet


class Backend:
    """Keeps programs and meshes on the GPU; live no longer than the context it is used in."""

    name = "gpu"
    batch_samples = 1 << 22  # an atlas texture holds as many, or one path

    def __init__(self):
        self._programs = Programs()
        self._surfaces = {}  # version of a surface -> batch of its triangles

    def visibility(self, frame):
        """(samples,) float32 in [0, 1] of a Frame's atlas."""
        core, clipped = native.load(), frame.clipped
        result = np.zeros(clipped.samples, np.float32)
        batches = core.atlas_batches(clipped, self.batch_samples)
        if not batches:
            return result
        layout = depth_layout(frame.view, frame.depth_scale)
        depth = self.draw_depth(frame.scene, frame.view, layout)
        sides = core.OwnSides(clipped, frame.scene, frame.view)
        for batch in batches:
            tables = core.atlas_tables(clipped, sides, batch)
            count = batch.sample_end - batch.sample_begin
            samples = self._look(tables, depth, layout, count, frame.probes)
            result[batch.sample_begin : batch.sample_end] = samples
        return result

    def draw_depth(self, scene, view, layout):
        """Target with (depth, slope right, slope up, facet modulo 2^24 or -1) per texel, and the edges of its triangle;
        see native/atlas/depth.h."""
        target = Target(layout.width, layout.height, "RGBA32F", second="RG32F", depth=True)
        # Orthographic depth goes on below 0 beyond the far plane; the window has no room for that as it is.
        window_depth = (0.5, 0.5) if view.orthographic else (1.0, 0.0)
        draws = native.load().depth_draws(scene, view, layout)
        self._keep_surfaces(scene, draws)
        with target.bind() as framebuffer:
            framebuffer.clear(color=_BACKGROUND, depth=0.0)
            gpu.state.depth_test_set("GREATER")
            gpu.state.depth_mask_set(True)
            program = self._programs.bind("depth", window_depth=window_depth, buffer_scale=float(layout.scale))
            for version, _, matrix, facet_base in draws:
                program.uniform_float("object_to_depth_clip", matrix)
                program.uniform_int("facet_base", facet_base)
                self._surfaces[version].draw(program)
        return target

    def _keep_surfaces(self, scene, draws):
        """Has a batch for every surface that is drawn, and for no other."""
        core, kept = native.load(), {}
        for version, placement, _, _ in draws:
            if version in kept:
                continue
            kept[version] = self._surfaces.get(version)
            if kept[version] is None:
                positions, facets = core.depth_corners(scene, placement)
                buffer = vertex_buffer({"position": positions, "facet": facets})
                kept[version] = gpu.types.GPUBatch(type="TRIS", buf=buffer)
        self._surfaces = kept

    def _look(self, tables, depth, layout, count, probes):
        """Visibility of the samples of one batch."""
        segments, owners = (upload_row(table) for table in tables)
        target = Target(ROW_WIDTH, -(-count // ROW_WIDTH), "R32F")
        with target.bind():
            self._programs.cover(
                "visibility",
                {"segments": segments, "owners": owners, "depth_buffer": depth.color, "edge_buffer": depth.second},
                border=(layout.border_x, layout.border_y),
                buffer_scale=float(layout.scale),
                bias=native.load().SAMPLED_BIAS,
                slack_px=native.load().SAMPLED_SLACK_PX,
                sample_total=count,
                probes=probes,
            )
        return target.read(1).reshape(-1)[:count]

    def draw(self, strokes, pens, textures, view):
        """(height, width, 4) float32: strokes alone, premultiplied, bottom row first."""
        if len(strokes.triangles) == 0:
            return np.zeros((view.height, view.width, 4), np.float32)
        pen_rows, ink = native.load().pen_table(pens, textures.native)
        samplers = {"pens": upload_row(pen_rows), "ink": upload_row(ink)}
        target = Target(view.width, view.height, "RGBA32F")
        with target.bind() as framebuffer:
            framebuffer.clear(color=(0.0, 0.0, 0.0, 0.0))
            gpu.state.blend_set("ALPHA_PREMULT")
            program = self._programs.bind("stroke", samplers, image_size=(view.width, view.height))
            attributes = {
                "px": strokes.px,
                "arc": strokes.arc,
                "width_opacity": np.stack((strokes.half_width, strokes.opacity), axis=1),
                "pen": strokes.pen,
            }
            draw_triangles(program, attributes, strokes.triangles)
        return target.read(4)


def depth_layout(view, scale):
    """The DepthLayout of a View; coarser than asked for where the GPU's textures are not as large."""
    layout = native.load().DepthLayout(view, scale)
    too_large = max(layout.width, layout.height) > size_limit()
    return depth_layout(view, scale - 1) if too_large and scale > 1 else layout
