"""What focus and distance make of a frame: numbers per sample and per pixel, from a style's data."""

import numpy as np

from .backend import cpu
from .stages import Emphasis


def of_lines(frame, style):
    """Emphasis of the samples, before elision."""
    return Emphasis(_focus_of_lines(frame, style), _distance_of_lines(frame, style))


def of_pixels(frame, style, distance):
    """(H, W) float32 focus; `distance` (H, W) of what each pixel shows, along the view. None: all is in focus."""
    if style.effects.colors == "uniform":
        return np.full((frame.view.height, frame.view.width), style.effects.uniform, np.float32)
    if not style.focus.active():
        return None
    return cpu.focus_of_pixels(frame.view, distance, cpu.focus_of(style.focus, frame.view))


def mix(transfer, values):
    """(n,) mixes of a style's Transfer; 0 without values."""
    return 0.0 if values is None or transfer.strength == 0.0 else cpu.transfer(transfer)(values)


def both(a, b):
    """What two causes make of one effect, each a mix in [0, 1]."""
    return 1 - (1 - a) * (1 - b)


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
