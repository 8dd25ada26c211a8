# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a GPU draws as the CPU does. It is tried once per process, GPU and method of visibility, before the GPU draws
anything by that method: a small scene is drawn by both. A GPU that draws otherwise, or fails, draws nothing: pictures
are the CPU's then.

Pictures of a right GPU differ from the CPU's by rounding, and where a sample lies just at an edge.
"""

import logging
import time
from dataclasses import dataclass

import numpy as np

from .. import native, pipeline, still_life, style
from ..gpu import device
from ..scene import scene
from ..stages import View
from ..style import style_picture

SIZE = 96  # pixels along each side
DIFFERENT = 0.1  # a pixel is another one if a channel differs by more than this, in [0, 1]
MOST_DIFFERENT = 0.01  # share of the pixels that may be others
MOST_MEAN = 0.001  # mean difference that channels may have; that of right GPUs is a thirtieth of it
NOTE = "The GPU draws otherwise than the CPU, which draws instead"

_log = logging.getLogger(__package__)
_findings = {}  # (description of a GPU, method of visibility) -> Finding


@dataclass(frozen=True)
class Finding:
    """What was found of a GPU."""

    trouble: str  # what is wrong with it; empty if nothing is
    milliseconds: float


def note(make_backend, method):
    """NOTE if the GPU of the current context does not draw as the CPU does by a method of visibility, else an empty
    string. `make_backend()` gives the gpu backend; it is called if that is tried now."""
    tried = device.description(), method
    if tried not in _findings:
        _findings[tried] = _tried(make_backend, method)
    return NOTE if _findings[tried].trouble else ""


def lines():
    """Text lines on the GPUs that were tried in this process."""
    for (described, method), found in _findings.items():
        verdict = "draws otherwise than the CPU, which draws instead: " if found.trouble else "draws as the CPU does"
        yield f"{described}: with visibility {method} it {verdict}{found.trouble}, tried in {found.milliseconds:.0f} ms"


def forget():
    """Every GPU is tried again."""
    _findings.clear()


def _tried(make_backend, method):
    start = time.perf_counter()
    try:
        trouble = _trouble(make_backend(), method)
    except Exception as error:  # of the driver's compiler, for example
        _log.exception("the GPU failed")
        trouble = f"{type(error).__name__}: {str(error).strip().partition(chr(10))[0]}"
    return Finding(trouble, 1000 * (time.perf_counter() - start))


def _trouble(backend, method):
    """What differs between pictures of the gpu backend and the CPU's; empty if they are as alike as they should be."""
    drawn, reference = (_picture(each, method) for each in (backend, native.load().CpuBackend()))
    if not np.isfinite(drawn).all():
        return "pixels are no numbers"
    off = np.abs(drawn - reference)
    others, mean = (off.max(axis=2) > DIFFERENT).mean(), off.mean()
    if others > MOST_DIFFERENT or mean > MOST_MEAN:
        return f"{100 * others:.1f} % of the pixels differ, on average by {mean:.3f}"
    return ""


def _picture(backend, method):
    """(SIZE, SIZE, 4) lines of boards one behind the other, thinned where the method can."""
    placed, _ = style_picture.scene_of(still_life.boards)
    world_to_view, clip, near, far = still_life.view()
    view = scene.seen(native.load(), View(world_to_view, clip, SIZE, SIZE, False, near, far, SIZE / 240))
    options = pipeline.options(visibility=method, depth_scale=2, probes=4, layers=2)
    return pipeline.draw(placed, view, _style(), backend, options).lines


def _style():
    """Lines of a shipped style, wide and close enough to each other to be thinned, with a texture."""
    pen = style.Pen(width=3.0, texture="pencil", spacing=12.0)
    sets = (each.replace(least_length=0.0, pen=pen) for each in style.load("pen_and_ink").line_sets)
    return style.Style(line_sets=tuple(sets), elision=style.Elision(enabled=True))
