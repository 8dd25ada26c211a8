# SPDX-License-Identifier: GPL-3.0-or-later
"""What focus, distance and elision make of a frame: numbers per sample and per pixel, from a style's data."""

from dataclasses import replace

import numpy as np

from .backend import cpu, cpu_focus
from .stages import Emphasis

_STUB = 12.0  # reference pixels; what elision leaves of a line in shorter pieces goes, too
_MOST_DENSITY = 4.0  # where a density map is white


def of_lines(frame, style):
    """Emphasis of the samples along the lines, before elision."""
    return Emphasis(_focus_of_lines(frame, style), _distance_of_lines(frame, style))


def thinned(felt, frame, runs, style, backend, cancel, near=()):
    """An Emphasis with what elision leaves of Runs, smoothed in time where there is something `near`: pairs of how many
    frames later another is and its `shown_lines`."""
    elision = style.elision
    if not near:
        return replace(felt, shown=_left(felt, frame, runs, style, backend, cancel, elision.cut))
    shown = _left(felt, frame, runs, style, backend, cancel)
    shown = cpu.smoothed_in_time(shown, cpu.shown_lines(frame, runs, shown), near, elision.frames)
    return replace(felt, shown=np.where(shown < elision.cut, np.float32(0), shown))


def shown_lines(felt, frame, runs, style, backend, cancel):
    """What elision leaves of Runs, for frames near this one."""
    return cpu.shown_lines(frame, runs, _left(felt, frame, runs, style, backend, cancel))


def _left(felt, frame, runs, style, backend, cancel, cut=0.0):
    """(samples,) what elision leaves of Runs in this frame."""
    elision = style.elision
    painted = cpu_focus.values_on_paths(frame, elision.priority_attribute) if elision.priority_attribute else None
    ranks = cpu.ranks(frame, runs, cpu.priorities(frame, elision.weights(), frame.notes.importance, painted))
    options = {"fade_from": elision.fade_from, "cut": cut, "stub_px": _STUB * frame.view.reference_scale}
    return backend.elide(frame, runs, ranks, _half_width(felt, frame, runs, style), cancel, **options)


def of_pixels(frame, style, cancel, step=1):
    """(H, W) float32 focus of what each pixel shows, or None where all is in focus. Evaluated at pixels so many apart,
    where it takes rays; those between are as the nearest of them."""
    focus, view = style.focus, frame.view
    if not focus.active():
        return None
    if step > 1 and focus.model != "image":
        return cpu_focus.magnified(of_pixels(_with_fewer_pixels(frame, focus, step), style, cancel), view)
    if focus.model == "painted":
        return 1 - cpu_focus.painted_image(frame, focus.attribute, cancel)
    flat = focus.model == "image"
    distance = np.zeros((view.height, view.width), np.float32) if flat else depth_image(frame, cancel)
    return cpu_focus.focus_of_pixels(view, distance, _focus(frame, focus))


def _with_fewer_pixels(frame, focus, step):
    """A Frame, as far as the focus of its pixels asks for it; focus in the scene does not depend on them."""
    view = frame.view.smaller(1 / step)
    return replace(frame, view=view, tracer=cpu.trace(frame.scene, view), made={"focus": _focus(frame, focus)})


def depth_image(frame, cancel):
    """(H, W) distance along the view of what each pixel sees."""
    return frame.once("depth image", lambda: cpu.depth_image(frame.tracer, cancel))


def _focus(frame, focus):
    """The native Focus of a Frame: lines and pixels ask it, and an object's surface takes time to make."""
    return frame.once("focus", lambda: cpu_focus.focus_of(focus, frame))


def colors_answer(layer, style):
    """Whether a colour layer (None: there is none) needs the focus of each pixel."""
    effects = style.effects
    strongest = max(effects.desaturation.strength, effects.fade.strength, effects.blur.strength)
    return layer is not None and effects.colors == "emphasized" and strongest > 0 and style.focus.active()


def on_color(layer, focus, frame, style):
    """A colour layer with what answers to the focus of each pixel."""
    effects, radius = style.effects, style.effects.blur_radius * frame.view.reference_scale
    if effects.colors == "uniform":
        focus = np.full(layer.shape[:2], effects.uniform, np.float32)
    if focus is None:
        return layer
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
    if style.focus.model == "painted":
        return 1 - _painted(frame, style.focus.attribute)
    return cpu_focus.focus_of_samples(frame.clipped, _focus(frame, style.focus))


def _painted(frame, attribute):
    """(samples,) what is painted along the lines."""
    return cpu_focus.values_of_samples(frame.clipped, cpu_focus.values_on_paths(frame, attribute))


def _distance_of_lines(frame, style):
    distance = style.distance
    strongest = max(distance.width.strength, distance.opacity.strength, distance.density.strength)
    if strongest == 0.0 or not style.has_away():
        return None
    return cpu_focus.distance_of_samples(frame.clipped, distance.near, distance.far)


def _half_width(felt, frame, runs, style):
    """(samples,) float32 pixels: half the distance that lines want to keep from others, the inverse of their density;
    0 on pieces without Runs, which may be most."""
    at, path = cpu.samples_with_runs(frame.clipped, runs)
    half_width = np.zeros(frame.clipped.samples, np.float32)
    spacing = _spacing(style, frame.paths.line_set[path], felt, at)
    half_width[at] = 0.5 * frame.view.reference_scale * spacing / _wanted(frame, style.elision, at)
    return half_width


def _wanted(frame, elision, at):
    """How many times as dense as their pens say lines may be: at some samples, from 1/4 where a density map is black
    to 4 where it is white; or 1."""
    density = 1.0
    if elision.density_attribute:
        density = density * _MOST_DENSITY ** (2 * _painted(frame, elision.density_attribute)[at] - 1)
    if frame.notes.density_map is not None:
        density = density * _MOST_DENSITY ** (2 * cpu_focus.map_of_samples(frame, frame.notes.density_map)[at] - 1)
    return density


def _spacing(style, line_set, felt, at):
    """(n,) reference pixels that lines want to keep from each other at some samples, of these line sets."""
    near = np.array([s.pen.spacing for s in style.line_sets], np.float32)[line_set]
    away = np.array([(s.pen_away or s.pen).spacing for s in style.line_sets], np.float32)[line_set]
    by_focus, by_distance = (
        mix(transfer, None if values is None else values[at])
        for transfer, values in ((style.effects.density, felt.focus), (style.distance.density, felt.distance))
    )
    return (near + (away - near) * (1 - (1 - by_focus) * (1 - by_distance))).astype(np.float32)
