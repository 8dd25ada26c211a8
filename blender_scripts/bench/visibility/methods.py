# SPDX-License-Identifier: GPL-3.0-or-later
"""The methods that are compared. All but OGL run the pipeline as in a render, on the gpu backend.

The GPU is waited for after each drawing pass. Paper and the read-back of the picture are not counted, as a viewport
does not need them."""

import time
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
from bl_ext.user_default.fovea import pipeline
from bl_ext.user_default.fovea.gpu import backend as gpu

from .plain_lines import PlainLines

QUALITY = {  # probes, texels of the depth buffer to a pixel along each axis, layers of the item buffer
    "IBlo": (1, 1, 1),
    "IBhi": (1, 3, 3),
    "STlo": (1, 1, 1),
    "SThi": (9, 2, 1),
    "SAlo": (1, 1, 1),
    "SAhi": (9, 2, 1),
}
KINDS = {"IB": "item_buffer", "ST": "spine", "SA": "atlas", "ex": "exact"}


@dataclass(frozen=True)
class Frame:
    """A method's result for one view."""

    stages: dict  # name -> milliseconds
    scene: object
    paths: object
    clipped: object
    visibility: np.ndarray | None  # (samples,) float32 in [0, 1]; None: the method computes none
    orthographic: bool

    @property
    def segments(self):
        """Number of segments at least partly inside the frame."""
        return int(np.count_nonzero(self.clipped.sample_count))

    @property
    def samples(self):
        return self.clipped.samples

    @property
    def edge_counts(self):
        """(n,) edges of each placement's mesh."""
        return np.array([len(self.scene.surface(i).edges) for i in range(len(self.scene))])

    def placement_of(self, point):
        """Placement of points of the paths."""
        return np.repeat(self.paths.placement, np.diff(self.paths.offsets))[point]


def make(name, world, style, options):
    """The method of that name, from METHODS in __init__.py."""
    if name == "OGL":
        return OpenGL(world, style, options)
    probes, scale, layers = QUALITY.get(name, (1, 1, 1))
    asked = options.replace(visibility=KINDS[name[:2]], probes=probes, depth_scale=scale, layers=layers)
    return Method(world, style, asked)


@contextmanager
def passes(backend):
    """Context with {pass: milliseconds} of the GPU passes run inside it."""
    backend.clock.stages = found = {}
    try:
        yield found
    finally:
        backend.clock.stages = None


class Method:
    def __init__(self, world, style, options):
        self.world, self.style, self.options, self.backend = world, style, options, gpu.Backend()

    def frame(self, view):
        made = pipeline.frame(self.world.placed, self.world.seen(view), self.style, self.backend, self.options)
        with passes(self.backend) as inside:
            made.see()
        # Of what is seen: filters take folds out of contours, which ones depends on the method.
        paths, clipped, visibility = made.paths, made.clipped, self.samples(made)
        with passes(self.backend) as drawn:
            made.ink()
        whole = made.stages
        stages = {name: whole[name] for name in ("bvh", "lines", "project")}
        stages |= inside or {"visibility": whole["visibility"]}
        rest = whole["visibility"] - sum(inside.values()) if inside else 0.0
        stages |= {"runs": rest + whole["runs"], "shape": whole["shape"]}
        for name, ms in drawn.items():
            if name != "read":
                stages[name] = stages.get(name, 0.0) + ms
        return Frame(stages, self.world.placed, paths, clipped, visibility, view.orthographic)

    def samples(self, frame):
        """(samples,) visibility. The spine test has none before drawing, so its probes are evaluated at the samples."""
        if self.options.visibility == "spine":
            return self.backend.visibility(frame)
        return frame.visible.samples(frame.clipped)


class OpenGL:
    """Plain OpenGL lines. Projection is only needed to count segments and is not timed."""

    def __init__(self, world, style, options):
        self.world, self.style, self.options = world, style, options
        self.plain = PlainLines(world.placed, world.object_to_world)

    def frame(self, view):
        made = pipeline.frame(self.world.placed, self.world.seen(view), self.style, None, self.options)
        made.find()
        stages = {name: made.stages[name] for name in ("bvh", "lines")}
        with timed(stages, "upload"):
            self.plain.upload(made.paths)
        with timed(stages, "draw"):
            self.plain.draw(view.view_to_clip @ view.world_to_view, view.width, view.height)
        return Frame(stages, self.world.placed, made.paths, made.clipped, None, view.orthographic)


@contextmanager
def timed(stages, name):
    start = time.perf_counter()
    yield
    stages[name] = 1000 * (time.perf_counter() - start)
