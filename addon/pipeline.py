# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole method on one page: from a scene and a camera to strokes on paper."""

import time
from contextlib import contextmanager
from dataclasses import dataclass, field

from . import emphasis, papers
from .backend import cpu, cpu_lines
from .stages import Image, Notes
from .textures import Textures
from .visibility import METHODS


@dataclass(frozen=True)
class Options:
    """Numbers of the method that are not the style's."""

    visibility: str = "exact"  # which of METHODS
    sample_step: float = 2.0  # reference pixels between visibility samples
    depth_scale: int = 2  # texels of the depth buffer per pixel, along each axis
    probes: int = 9  # looks into the depth buffer per sample
    layers: int = 3  # lines that a texel of the item buffer holds
    gap: float = 3.0  # reference pixels of hidden line that are drawn over; more than one sample
    spur: float = 1.0  # reference pixels of visible line that are left out
    contour_spur: float = 10.0  # the same inside contours, which break up where they end on a smooth surface
    fold: float = 30.0  # reference pixels up to which a contour's end may fold back and is cut off
    meet: float = 8.0  # reference pixels that a contour is drawn on over facets of its own, to a line that goes on
    beside: float = 4.0  # reference pixels to a visible line at which a hidden one that goes along it is left out
    least_hidden: float = 6.0  # reference pixels; shorter hidden parts between visible ones are left out
    # Drafts: line sets (index, kinds) that draw of these kinds only what is the outer boundary of its object. What is
    # not goes to the next set that wants it. Hidden parts have no pens then.
    outlines: tuple = ()
    focus_step: int = 1  # drafts: pixels between those whose focus is evaluated for the colours under the lines
    with_depth: bool = False  # also make the depth pass
    with_focus: bool = False  # and that of focus, where the style has one


@dataclass(frozen=True)
class Frame:
    """One picture on its way: native handles, each stage's result beside the last."""

    scene: object  # native Scene
    view: object  # native View
    tracer: object  # native Tracer
    paths: object  # native Paths
    clipped: object  # native ClippedPaths
    depth_scale: int
    probes: int
    layers: int = 3
    notes: Notes = Notes()  # what the artist says of the placements
    made: dict = field(default_factory=dict)  # what several stages ask for

    def once(self, what, make):
        """make(), when a stage asks for it first."""
        if what not in self.made:
            self.made[what] = make()
        return self.made[what]


class _Clock:
    """Milliseconds per stage, and a word to the user before each."""

    def __init__(self, progress):
        self.stages, self.progress, self.done = {}, progress, 0.0

    @contextmanager
    def stage(self, name, share):
        self.progress(self.done, name)
        start = time.perf_counter()
        yield
        self.stages[name] = 1000 * (time.perf_counter() - start)
        self.done += share


def find_lines(scene, view, style, backend, options, notes, cancel, clock=None):
    """A Frame; the Runs of its lines; the samples by which they fade, or None; and their Emphasis, before elision."""
    clock = clock or _Clock(lambda *_: None)
    scale, method = view.reference_scale, METHODS[options.visibility]
    with clock.stage("bvh", 0.2):
        tracer = cpu.trace(scene, view)
    with clock.stage("lines", 0.1):
        paths = cpu.extract(tracer, style, cancel, notes.filters)
    with clock.stage("project", 0.15):
        clipped = cpu.project(paths, tracer, style, options.sample_step * scale, scale, cancel)
    quality = options.depth_scale, options.probes, options.layers
    frame = Frame(scene, view, tracer, paths, clipped, *quality, notes)
    with clock.stage("visibility", 0.25):
        visible, samples = method.runs(frame, backend, cancel)
    with clock.stage("runs", 0.05):
        small = (length * scale for length in (options.gap, options.spur, options.contour_spur, options.fold))
        tidied = cpu.tidy(frame, visible, *small)
        levels = style.counted() if method.counts else min(style.counted(), 1)
        small = (length * scale for length in (options.beside, options.least_hidden, options.fold))
        parts = cpu.parts(frame, tidied, levels, *small, cancel)
        felt = emphasis.of_lines(frame, style)
    return frame, parts, samples, felt


def draw(scene, view, style, backend, options, *, colors=None, notes=Notes(), near=(), progress, cancel):
    """The Image of a native Scene as a native View sees it, drawn in a Style by a Backend. `colors`: the color.Sources
    of the scene, where the style has a colour layer. `notes`: what the artist says of its placements. `near`: where
    `frames_near` asks for them, pairs of how many frames later another is and its `shown_lines`."""
    clock, scale, method = _Clock(progress), view.reference_scale, METHODS[options.visibility]
    frame, parts, samples, felt = find_lines(scene, view, style, backend, options, notes, cancel, clock)
    if thins(style, options):
        with clock.stage("elision", 0.05):
            felt = emphasis.thinned(felt, frame, parts, style, backend, cancel, near)
    with clock.stage("shape", 0.05):
        mix = emphasis.mix(style.effects.overshoot, felt.focus)
        runs = cpu.at_ends(frame, parts, style, scale, options.meet * scale, mix)
        pen_of_run = None
        if options.outlines:
            runs, pen_of_run = cpu_lines.outlined(frame, runs, style, options.outlines, cancel)
        textures = Textures(style)
        pens = cpu.pens_of(style, textures, scale)
        strokes = cpu.shape(frame, runs, style, pens, samples, felt, pen_of_run)
    with clock.stage("strokes", 0.1):
        lines = method.draw(frame, backend, strokes, pens, textures)
    layer = focus = None
    if colors is not None and style.has_color():
        with clock.stage("color", 0.05):
            layer = cpu.color_layer(frame.tracer, colors, style.color, cancel)
    with clock.stage("focus", 0.05):
        if options.with_focus or emphasis.colors_answer(layer, style):
            focus = emphasis.of_pixels(frame, style, cancel, options.focus_step)
        if layer is not None:
            layer = emphasis.on_color(layer, focus, frame, style)
    with clock.stage("paper", 0.05):
        combined = cpu.on_paper(lines, layer, style, papers.texture(style.paper), frame.tracer, cancel)
    depth = None
    if options.with_depth:
        with clock.stage("depth", 0.05):
            depth = emphasis.depth_image(frame, cancel)
    statistics = {
        "stages": clock.stages,
        "strokes": strokes.count,
        "samples": frame.clipped.samples,
        "backend": backend.name,
        "visibility": method.told(frame),
    }
    return Image(combined, lines, depth, layer, focus, statistics)


def frames_near(style, options):
    """Over how many frames before and after it a frame is smoothed in time."""
    return style.elision.frames if thins(style, options) else 0


def shown_lines(scene, view, style, backend, options, *, notes=Notes(), progress, cancel):
    """What frames near by need to know of a frame: what elision leaves of its lines. None where it thins nothing."""
    if not thins(style, options):
        return None
    frame, parts, _, felt = find_lines(scene, view, style, backend, options, notes, cancel, _Clock(progress))
    return emphasis.shown_lines(felt, frame, parts, style, backend, cancel)


def thins(style, options):
    """Whether a Style's elision can be done in this way of finding what is visible."""
    return style.elision.enabled and METHODS[options.visibility].knows
