# SPDX-License-Identifier: GPL-3.0-or-later
"""The methods that are compared. All but OGL are the pipeline itself, as a render runs it, on the gpu backend.

A pass that draws is waited for. Neither paper nor the read-back of the picture counts: a viewport needs none."""

import time
from contextlib import contextmanager
from dataclasses import dataclass, replace

import numpy as np
from bl_ext.user_default.fovea import native, pipeline, visibility
from bl_ext.user_default.fovea.backend import cpu, gpu

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
    """What a method says of one view."""

    stages: dict  # name -> milliseconds
    scene: object
    paths: object
    clipped: object
    visibility: np.ndarray | None  # (samples,) float32; None: the method has none
    orthographic: bool

    @property
    def segments(self):
        """That lie in the frame, at least in part."""
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
    """The method of that name in the table."""
    if name == "OGL":
        return OpenGL(world, style, options)
    probes, scale, layers = QUALITY.get(name, (1, 1, 1))
    options = replace(options, visibility="recorded", probes=probes, depth_scale=scale, layers=layers)
    return Method(visibility.METHODS[KINDS[name[:2]]], world, style, options)


class Recorder:
    """A method of the pipeline that keeps what went through it; in all else it is that method."""

    def __init__(self, method):
        self.method = method

    def __getattr__(self, name):
        return getattr(self.method, name)

    def runs(self, frame, backend, cancel):
        with passes(backend) as self.inside:
            self.frame, (self.found, samples) = frame, self.method.runs(frame, backend, cancel)
        return self.found, samples

    def draw(self, frame, backend, strokes, pens, textures):
        with passes(backend) as drawn:
            picture = self.method.draw(frame, backend, strokes, pens, textures)
        self.drawn = {name: ms for name, ms in drawn.items() if name != "read"}
        return picture


@contextmanager
def passes(backend):
    """{name: milliseconds} of the passes inside the block, and of none that a later stage draws."""
    backend.clock.stages = found = {}
    try:
        yield found
    finally:
        backend.clock.stages = None


class Method:
    def __init__(self, method, world, style, options):
        self.recorder, self.world, self.style, self.options = Recorder(method), world, style, options
        self.backend = gpu.Backend()
        self.cancel = native.load().Cancel()

    def frame(self, view):
        seen, recorder = self.world.seen(view), self.recorder
        pipeline.METHODS["recorded"] = recorder
        image = pipeline.draw(
            self.world.placed, seen, self.style, self.backend, self.options, progress=silent, cancel=self.cancel
        )
        whole = image.statistics["stages"]
        stages = {name: whole[name] for name in ("bvh", "lines", "project")}
        stages |= recorder.inside or {"visibility": whole["visibility"]}
        rest = whole["visibility"] - sum(recorder.inside.values()) if recorder.inside else 0.0
        stages |= {"runs": rest + whole["runs"], "shape": whole["shape"]}
        for name, ms in recorder.drawn.items():
            stages[name] = stages.get(name, 0.0) + ms
        clipped = recorder.frame.clipped
        return Frame(stages, self.world.placed, recorder.frame.paths, clipped, self.samples(), view.orthographic)

    def samples(self):
        """What was found visible. The spine test finds nothing before it draws: what its looks at the samples would say."""
        if self.recorder.method.name == "spine":
            return self.backend.visibility(self.recorder.frame)
        return native.load().samples_from_runs(self.recorder.frame.clipped, self.recorder.found)


class OpenGL:
    """Lines without style. Projection, which serves to count segments alone, is not timed."""

    def __init__(self, world, style, options):
        self.world, self.style, self.options = world, style, options
        self.plain = PlainLines(world.placed, world.object_to_world)
        self.cancel = native.load().Cancel()

    def frame(self, view):
        seen, stages = self.world.seen(view), {}
        with timed(stages, "bvh"):
            tracer = cpu.trace(self.world.placed, seen)
        with timed(stages, "lines"):
            paths = cpu.extract(tracer, self.style, self.cancel)
        with timed(stages, "upload"):
            self.plain.upload(paths)
        with timed(stages, "draw"):
            self.plain.draw(view.view_to_clip @ view.world_to_view, view.width, view.height)
        scale = view.reference_scale
        clipped = cpu.project(paths, tracer, self.style, self.options.sample_step * scale, scale, self.cancel)
        return Frame(stages, self.world.placed, paths, clipped, None, view.orthographic)


@contextmanager
def timed(stages, name):
    start = time.perf_counter()
    yield
    stages[name] = 1000 * (time.perf_counter() - start)


def silent(*_progress):
    pass
