"""What focus, distance and elision make of a frame: numbers per sample and per pixel, from a style's data."""

from dataclasses import replace

import numpy as np

from .backend import cpu
from .stages import Emphasis

_STUB = 12.0  # reference pixels; what elision leaves of a line in shorter pieces goes, too


def of_lines(frame, style):
    """Emphasis of the samples along the lines, before elision."""
    return Emphasis(_focus_of_lines(frame, style), _distance_of_lines(frame, style))


def thinned(felt, frame, runs, style, backend, cancel):
    """An Emphasis with what elision leaves of Runs."""
    if not style.elision.enabled:
        return felt
    elision, scale = style.elision, frame.view.reference_scale
    ranks = cpu.ranks(frame, runs, cpu.priorities(frame, elision.weights(), frame.importance))
    options = {"fade_from": elision.fade_from, "cut": elision.cut, "stub_px": _STUB * scale}
    half_width = 0.5 * scale * _spacing(frame, style, felt)
    return replace(felt, shown=backend.elide(frame, runs, ranks, half_width, cancel, **options))


def of_pixels(frame, style, cancel):
    """(H, W) float32 focus of what each pixel shows, or None where all is in focus."""
    view = frame.view
    if style.effects.colors == "uniform":
        return np.full((view.height, view.width), style.effects.uniform, np.float32)
    if not style.focus.active():
        return None
    in_scene = style.focus.model == "scene"
    distance = cpu.depth_image(frame.tracer, cancel) if in_scene else np.zeros((view.height, view.width), np.float32)
    return cpu.focus_of_pixels(view, distance, cpu.focus_of(style.focus, view))


def on_color(layer, focus, frame, style):
    """A colour layer with what answers to the focus of each pixel."""
    if focus is None:
        return layer
    effects, radius = style.effects, style.effects.blur_radius * frame.view.reference_scale
    return cpu.color_effects(
        layer,
        desaturate=_amounts(effects.desaturation, focus),
        fade=_amounts(effects.fade, focus),
        blur_px=_amounts(effects.blur, focus, radius),
        background=style.color.background,
    )


def mix(transfer, values):
    """(n,) mixes of a style's Transfer; 0 without values."""
    return 0.0 if values is None or transfer.strength == 0.0 else cpu.transfer(transfer)(values)


def _amounts(transfer, focus, most=1.0):
    """(H, W) amounts of a colour effect, or None where there are none."""
    return None if transfer.strength == 0.0 else most * mix(transfer, focus.ravel()).reshape(focus.shape)


def _focus_of_lines(frame, style):
    if not style.has_away():
        return None
    if style.effects.lines == "uniform":
        return np.full(frame.clipped.samples, style.effects.uniform, np.float32)
    if not style.focus.active():
        return None
    return cpu.focus_of_samples(frame.clipped, cpu.focus_of(style.focus, frame.view))


def _distance_of_lines(frame, style):
    distance = style.distance
    strongest = max(distance.width.strength, distance.opacity.strength, distance.density.strength)
    if strongest == 0.0 or not style.has_away():
        return None
    return cpu.distance_of_samples(frame.clipped, distance.near, distance.far)


def _spacing(frame, style, felt):
    """(samples,) reference pixels that lines want to keep from each other: the inverse of the density."""
    set_of_sample = frame.paths.line_set[cpu.path_of_samples(frame.clipped)]
    near = np.array([s.pen.spacing for s in style.line_sets], np.float32)[set_of_sample]
    away = np.array([(s.pen_away or s.pen).spacing for s in style.line_sets], np.float32)[set_of_sample]
    by_focus = mix(style.effects.density, felt.focus)
    by_distance = mix(style.distance.density, felt.distance)
    return (near + (away - near) * (1 - (1 - by_focus) * (1 - by_distance))).astype(np.float32)
