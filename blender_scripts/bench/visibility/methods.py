"""The methods that are compared, each a whole frame from the scene to pixels, with the time of its stages.

A stage that draws waits until the drawing is done."""

import time
from contextlib import contextmanager
from dataclasses import dataclass, replace

import numpy as np
from bl_ext.user_default.fovea import native, pipeline
from bl_ext.user_default.fovea.backend import cpu, gpu
from bl_ext.user_default.fovea.textures import Textures

from .plain_lines import PlainLines, finish


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


class Clock:
    """Time of stages without that of the stages inside them."""

    def __init__(self):
        self.stages, self.inside = {}, [0.0]

    @contextmanager
    def __call__(self, name):
        start = time.perf_counter()
        self.inside.append(0.0)
        yield
        whole = 1000 * (time.perf_counter() - start)
        self.stages[name] = self.stages.get(name, 0.0) + whole - self.inside.pop()
        self.inside[-1] += whole


class TimedBackend(gpu.Backend):
    """The gpu backend, which notes how long its passes take and waits for each."""

    clock = None  # of the frame that is drawn

    def draw_depth(self, *arguments):
        with self.clock("depth"):
            return finished(super().draw_depth(*arguments))

    def _look(self, *arguments):
        with self.clock("samples"):
            return super()._look(*arguments)


def finished(target):
    with target.bind() as framebuffer:
        finish(framebuffer)
    return target


class Method:
    """From a scene to strokes on a target; methods differ in `draw`, which gives samples or None."""

    def __init__(self, world, style, options):
        self.world, self.style, self.options = world, style, options
        self.cancel = native.load().Cancel()
        self.backend = TimedBackend()

    def frame(self, view):
        clock, scale, seen = Clock(), view.reference_scale, self.world.seen(view)
        self.backend.clock = clock
        with clock("lines"):
            tracer = cpu.trace(self.world.placed, seen)
            paths = cpu.extract(tracer, self.style, self.cancel)
        clipped = self.clip(paths, tracer, scale, clock)
        frame = pipeline.Frame(self.world.placed, seen, tracer, paths, clipped, self.options.depth_scale, self.options.probes)
        visibility = self.draw(frame, view, clock)
        return Frame(clock.stages, self.world.placed, paths, clipped, visibility, view.orthographic)

    def clip(self, paths, tracer, scale, clock):
        with clock("project"):
            return cpu.project(paths, tracer, self.style, self.options.sample_step * scale, scale, self.cancel)

    def strokes(self, frame, runs, clock):
        """The visible runs as strokes, on a target that nobody reads."""
        scale = frame.view.reference_scale
        with clock("shape"):
            textures = Textures(self.style)
            pens = cpu.pens_of(self.style, textures, scale)
            small = (getattr(self.options, name) * scale for name in ("gap", "spur", "contour_spur", "fold"))
            strokes = cpu.shape(frame, cpu.tidy(frame, runs, *small), self.style, pens)
        with clock("strokes"):
            finished(self.backend.paint(strokes, pens, textures, frame.view))


class Exact(Method):
    def draw(self, frame, view, clock):
        with clock("visibility"):
            runs = cpu.exact(frame, self.cancel)
        self.strokes(frame, runs, clock)
        return native.load().samples_from_runs(frame.clipped, runs)


class SegmentAtlas(Method):
    def draw(self, frame, view, clock):
        with clock("tables"):
            visibility = self.backend.visibility(frame)
        with clock("runs"):
            runs = cpu.runs(frame.clipped, visibility)
        self.strokes(frame, runs, clock)
        return visibility


class OpenGL(Method):
    """Lines without style. Projection, which serves to count segments alone, is not timed."""

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.plain = PlainLines(self.world.placed, self.world.object_to_world)

    def clip(self, paths, tracer, scale, clock):
        return super().clip(paths, tracer, scale, Clock())

    def draw(self, frame, view, clock):
        with clock("upload"):
            self.plain.upload(frame.paths)
        with clock("draw"):
            self.plain.draw(view.view_to_clip @ view.world_to_view, view.width, view.height)
        return None


def make(name, world, style, options):
    """The method of that name in the table."""
    if name == "exact":
        return Exact(world, style, options)
    if name == "OGL":
        return OpenGL(world, style, options)
    probes, scale = QUALITY[name[2:]]
    return KINDS[name[:2]](world, style, replace(options, probes=probes, depth_scale=scale))


QUALITY = {"lo": (1, 1), "hi": (9, 2)}  # probes, depth scale
KINDS = {"SA": SegmentAtlas}
