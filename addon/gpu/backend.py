# SPDX-License-Identifier: GPL-3.0-or-later
"""The gpu backend: depth, visibility and strokes as passes of Blender's gpu module. Use it where there is a context."""

import math

import gpu
import numpy as np

from .. import native
from .atlas import Atlas
from .clock import Clock
from .elision import ElisionPass, border_of
from .items import ItemPass, item_of_point
from .program import Programs, triangles
from .strokes import Picture, StrokePass, box_of, boxes
from .texture import Target, size_limit, upload_row

_BACKGROUND = (0.0, 0.0, 0.0, -1.0)  # depth, slopes, facet
_FAR = 160  # near clip distances: there the steps of clip space are as large as the bias of lines on surfaces


class Backend(native.load().Backend):
    """Keeps programs and meshes on the GPU; live no longer than the context it is used in."""

    name = "gpu"
    batch_samples = 1 << 22  # an atlas texture holds as many, or one path
    most_side = 6144  # texels of a tile, where the GPU can do more: 1.1 GB

    def __init__(self):
        super().__init__()
        self.clock = Clock()
        self._programs = Programs()
        self._items = ItemPass(self._programs)
        self.surfaces = {}  # version of a surface -> batch of its triangles

    def visibility(self, frame):
        """(samples,) float32 in [0, 1] of a Frame's atlas, by looking into the depth buffer, or by the item buffer; the
        core's, by methods that it alone knows. One depth tile after the other: no two of them are there at once."""
        looks = {"atlas": self._look, "spine": self._look, "item_buffer": self._look_for_items}
        look = looks.get(frame.options.visibility)
        if look is None:
            return native.load().CpuBackend(self.most_side).visibility(frame)
        self.clock.start()
        atlas = Atlas(self._programs, frame, self.batch_samples)
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
        atlas.add_table("items", item_of_point(frame.clipped))
        depth = self._depth(frame, layout)
        layers = self._items.draw(atlas, depth, layout, frame.options.layers)
        self.clock.mark("items", layers[-1])
        samplers = {f"layer{i}": layers[min(i, len(layers) - 1)].color for i in range(3)}
        atlas.run("item_samples", layout, samplers, layer_count=frame.options.layers)

    def layouts(self, frame, overlap_px=0):
        """DepthLayouts of a Frame: one, or tiles where it is too large. Cores are looked out of by so many pixels."""
        return frame.layouts(min(size_limit(), self.most_side), overlap_px)

    def _depth(self, frame, layout):
        depth = self.draw_depth(frame.scene, frame.view, layout)
        self.clock.mark("depth", depth)
        return depth

    def draw_depth(self, scene, view, layout):
        """Target with (depth, slope right, slope up, facet modulo 2^24 or -1) per texel, and the edges of its triangle;
        see native/fovea/visibility/depth.h."""
        target = Target(layout.width, layout.height, "RGBA32F", second="RG32F", depth=True)
        draws = layout.draws(scene, view)
        # Clip space leaves depth steps of 6e-8; perspective makes that a growing share of it, far away.
        far = not view.orthographic and native.load().depth_reach(scene, view) > _FAR * view.near_clip
        self._keep_surfaces(scene, draws)
        with target.bind() as framebuffer:
            framebuffer.clear(color=_BACKGROUND, depth=0.0)
            gpu.state.depth_test_set("GREATER")
            gpu.state.depth_mask_set(True)
            program = self._programs.bind("far_depth" if far else "depth", buffer_scale=float(layout.scale))
            for draw in draws:
                gpu.state.face_culling_set(draw.culled)
                program.uniform_float("object_to_depth_clip", draw.object_to_depth_clip)
                program.uniform_int("facet_base", draw.facet_base)
                self.surfaces[draw.surface_version].draw(program)
        return target

    def _keep_surfaces(self, scene, draws):
        """Has a batch for every surface that is drawn, and for no other."""
        kept = {}
        for draw in draws:
            version = draw.surface_version
            if version not in kept:
                kept[version] = self.surfaces.get(version) or _batch(scene.surface(draw.placement))
        self.surfaces = kept

    def elide(self, frame, elision):
        """(D, 2) float32: pixels of each sample's band that others take, pixels that it has; as the cpu backend's."""
        self.clock.start()
        passes = ElisionPass(self._programs, elision, self.batch_samples)
        for box in boxes(frame.view.width, frame.view.height, self._elision_side(elision)):
            if frame.cancel.requested:
                raise native.load().Cancelled("cancelled")
            passes.look(box, frame.view, self.clock)
        crowding = passes.read()
        self.clock.mark("read")
        return crowding

    def _elision_side(self, elision):
        """Pixels of a tile's side that are left when its border is taken off, on both sides."""
        return max(min(size_limit(), self.most_side) - 2 * border_of(elision), 64)

    def draw(self, frame):
        """(height, width, 4) float32: a Frame's strokes alone, premultiplied, bottom row first."""
        if frame.options.visibility == "spine":
            return self._draw_spine(frame)
        return self.draw_strokes(frame.strokes, frame.pens, frame.textures, frame.view)

    def draw_strokes(self, strokes, pens, textures, view):
        """The same of strokes that nothing hides."""
        picture = Picture(view)
        if len(strokes.triangles) == 0:
            return picture.pixels
        self.clock.start()
        passes = StrokePass(self._programs, strokes, pens, textures)
        self.clock.mark("upload")
        for box in boxes(view.width, view.height, min(size_limit(), self.most_side)):
            self._put(picture, box, passes.draw(box))
        return picture.pixels

    def _draw_spine(self, frame):
        """By the spine test: every pixel is as opaque as its stroke is visible next to it."""
        picture, strokes = Picture(frame.view), frame.strokes
        if len(strokes.triangles) == 0:
            return picture.pixels
        self.clock.start()
        sides = native.load().OwnSides(frame.clipped, frame.scene, frame.view)
        segments = upload_row(sides.spine_table(frame.clipped))
        offsets = frame.clipped.offsets.astype(np.float32)
        ranges = np.stack((offsets[strokes.piece], offsets[strokes.piece + 1] - 2), axis=1)
        passes = StrokePass(self._programs, strokes, frame.pens, frame.textures, ranges)
        self.clock.mark("upload")
        for layout in self.layouts(frame, math.ceil(2 * strokes.half_width.max())):
            box = box_of(layout, frame.view)
            if box[0] < box[2] and box[1] < box[3]:
                self._put(picture, box, self._draw_seen(frame, layout, box, passes, segments))
        return picture.pixels

    def _draw_seen(self, frame, layout, box, passes, segments):
        depth = self._depth(frame, layout)
        samplers = {"segments": segments, **_looked_into(depth)}
        border = (layout.border_x, layout.border_y)
        return passes.draw(box, "spine", samplers, border=border, buffer_scale=float(layout.scale), **_looks(frame))

    def _put(self, picture, box, target):
        self.clock.mark("strokes", target)
        picture.paste(box, target)
        self.clock.mark("read")


def _looked_into(depth):
    """Samplers of a depth Target."""
    return {"depth_buffer": depth.color, "edge_buffer": depth.second}


def _looks(frame):
    """Constants of looking into the depth buffer."""
    options = native.load().SampledOptions()
    return {"bias": options.bias, "slack_px": options.slack_px, "probes": frame.options.probes}


def _batch(surface):
    """The triangles of a native Surface that hide lines, with their facets."""
    corners = native.load().DepthCorners(surface)
    return triangles({"position": corners.positions, "facet": corners.facets})
