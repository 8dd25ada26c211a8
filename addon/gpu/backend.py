# SPDX-License-Identifier: GPL-3.0-or-later
"""The gpu backend: depth, visibility, elision and strokes as passes of Blender's gpu module. Needs a GPU context."""

import math

import gpu
import numpy as np

from .. import native
from .atlas import Atlas
from .clock import Clock
from .elision import ElisionPass, border_of
from .items import ItemPass, item_of_point
from .program import Programs, triangles
from .strokes import StrokePass, box_of, boxes
from .texture import Target, size_limit, upload_row

_BACKGROUND = (0.0, 0.0, 0.0, -1.0)  # depth, slopes, facet
_FAR = 160  # distance in near_clip at which the quantization of clip-space depth reaches the bias of the depth test


class Backend(native.load().Backend):
    """Holds programs and meshes on the GPU; must not outlive the GPU context it is used in."""

    name = "gpu"
    batch_samples = 1 << 22  # most samples in an atlas texture, unless a single piece has more
    most_side = 6144  # texels: upper limit for the side of a tile, which then takes 1.1 GB

    def __init__(self):
        super().__init__()
        self.clock = Clock()
        self._programs = Programs()
        self._items = ItemPass(self._programs)
        self.surfaces = {}  # surface version -> GPUBatch of its triangles

    def visibility(self, frame):
        """(samples,) float32 in [0, 1]: visibility of a Frame's atlas samples, by probes of the depth buffer or by the
        item buffer. Methods without a GPU implementation run on the CPU. Only one depth tile is in memory at once."""
        looks = {"atlas": self._look, "spine": self._look, "item_buffer": self._look_for_items}
        look = looks.get(frame.options.visibility)
        if look is None:
            return native.load().CpuBackend(self.most_side).visibility(frame)
        self.clock.start()
        atlas = Atlas(self._programs, frame, self.batch_samples)
        if look == self._look_for_items:
            atlas.add_table("items", item_of_point(frame.clipped))
        self.clock.mark("tables")
        for layout in self.layouts(frame) if atlas.batches else ():
            look(atlas, frame, layout)
            self.clock.mark("samples", atlas.batches[-1].target)
        result = atlas.read()
        self.clock.mark("read")
        return result

    def _look(self, atlas, frame, layout):
        depth = self._depth(frame, layout)
        atlas.run("visibility", layout, _looked_into(depth), **_looks(frame))

    def _look_for_items(self, atlas, frame, layout):
        depth = self._depth(frame, layout)
        layers = self._items.draw(atlas, depth, layout, frame.options.layers)
        self.clock.mark("items", layers[-1])
        samplers = {f"layer{i}": layers[min(i, len(layers) - 1)].color for i in range(3)}
        atlas.run("item_samples", layout, samplers, layer_count=frame.options.layers)

    def layouts(self, frame, overlap_px=0):
        """DepthLayouts of a Frame: one, or tiles if it exceeds the size limit. `overlap_px`: pixels that each tile
        shows around its core."""
        return frame.layouts(min(size_limit(), self.most_side), overlap_px)

    def _depth(self, frame, layout):
        depth = self.draw_depth(frame.scene, frame.view, layout)
        self.clock.mark("depth", depth)
        return depth

    def draw_depth(self, scene, view, layout):
        """Target with (depth, ddx, ddy, facet modulo 2^24 or -1 for background) per texel in its first texture and the
        encoded edges of the texel's triangle in its second; see native/fovea/visibility/depth.h."""
        target = Target(layout.width, layout.height, "RGBA32F", second="RG32F", depth=True)
        draws = layout.draws(scene, view)
        # Depth interpolated in clip space has steps of 6e-8, a relative error that grows with distance in perspective.
        far = not view.orthographic and native.load().depth_reach(scene, view) > _FAR * view.near_clip
        self._keep_surfaces(scene, draws)
        with target.bind("GREATER") as framebuffer:
            framebuffer.clear(color=_BACKGROUND, depth=0.0)
            cut = native.load().has_section(scene)
            name = "section_depth" if cut else "far_depth" if far else "depth"
            program = self._programs.bind(name, buffer_scale=float(layout.scale))
            for draw in draws:
                gpu.state.face_culling_set(draw.culled)
                program.uniform_float("object_to_depth_clip", draw.object_to_depth_clip)
                program.uniform_int("facet_base", draw.facet_base)
                if cut:
                    program.uniform_float("section", draw.cut)
                batch = self.surfaces[draw.surface_version]
                batch.draw_range(program, elem_start=draw.first, elem_count=draw.count)
        return target

    def _keep_surfaces(self, scene, draws):
        """Uploads the surfaces that are drawn and drops all others."""
        kept = {}
        for draw in draws:
            version = draw.surface_version
            if version not in kept:
                kept[version] = self.surfaces.get(version) or _batch(scene.surface(draw.placement))
        self.surfaces = kept

    def elide(self, frame, elision):
        """(D, 2) float32 per sample that runs cover: pixels of its band in the window that are lost to lines of higher
        rank, and pixels of its band in the window; as the cpu backend computes them."""
        self.clock.start()
        passes = ElisionPass(self._programs, elision, self.batch_samples)
        for box in boxes(frame.view.width, frame.view.height, self._elision_side(elision)):
            if frame.cancel.requested:
                raise native.cancelled()
            passes.look(box, frame.view, self.clock)
        crowding = passes.read()
        self.clock.mark("read")
        return crowding

    def _elision_side(self, elision):
        """Side of an elision tile in pixels without the border on both sides; at least 64."""
        return max(min(size_limit(), self.most_side) - 2 * border_of(elision), 64)

    def draw(self, frame, image=None):
        """Draws a Frame's strokes alone into `image` (height, width, 4) float32, premultiplied, bottom row first, and
        returns it; None: into a new one."""
        if image is None:
            image = np.empty((frame.view.height, frame.view.width, 4), np.float32)
        self.clock.start()
        if len(frame.strokes.triangles) == 0:
            image.fill(0.0)
        elif frame.options.visibility == "spine":
            self._draw_spine(frame, image)
        else:
            self._draw_strokes(frame, image)
        return image

    def _draw_strokes(self, frame, image):
        """Draws strokes without any visibility test."""
        passes = StrokePass(self._programs, frame.strokes, frame.pens, frame.textures)
        self.clock.mark("upload")
        for box in boxes(frame.view.width, frame.view.height, min(size_limit(), self.most_side)):
            self._put(image, box, passes.draw(box))

    def _draw_spine(self, frame, image):
        """Draws strokes with the spine test: a fragment's opacity is scaled by the visibility of its stroke's spine at
        the same arc length."""
        strokes = frame.strokes
        sides = native.load().OwnSides(frame.clipped, frame.scene, frame.view)
        segments = upload_row(sides.spine_table(frame.clipped))
        offsets = frame.clipped.offsets.astype(np.float32)
        ranges = np.stack((offsets[strokes.piece], offsets[strokes.piece + 1] - 2), axis=1)
        passes = StrokePass(self._programs, strokes, frame.pens, frame.textures, ranges)
        self.clock.mark("upload")
        image.fill(0.0)
        for layout in self.layouts(frame, math.ceil(2 * strokes.half_width.max())):
            box = box_of(layout, frame.view)
            if box[0] < box[2] and box[1] < box[3]:
                self._put(image, box, self._draw_seen(frame, layout, box, passes, segments))

    def _draw_seen(self, frame, layout, box, passes, segments):
        depth = self._depth(frame, layout)
        samplers = {"segments": segments, **_looked_into(depth)}
        border = (layout.border_x, layout.border_y)
        return passes.draw(box, "spine", samplers, border=border, buffer_scale=float(layout.scale), **_looks(frame))

    def _put(self, image, box, target):
        """Copies a Target to its box (left, lower, right, upper) of an image."""
        self.clock.mark("strokes", target)
        left, lower, right, upper = box
        image[lower:upper, left:right] = target.read(4)
        self.clock.mark("read")


def _looked_into(depth):
    """{sampler: texture} of a depth Target."""
    return {"depth_buffer": depth.color, "edge_buffer": depth.second}


def _looks(frame):
    """Push constants for probing the depth buffer."""
    options = native.load().SampledOptions()
    return {"bias": options.bias, "slack_px": options.slack_px, "probes": frame.options.probes}


def _batch(surface):
    """GPUBatch of the occluding triangles of a native Surface, with their facet numbers."""
    corners = native.load().DepthCorners(surface)
    return triangles({"position": corners.positions, "facet": corners.facets})
