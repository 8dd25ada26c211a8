# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of viewports: what one should show, and what it shows."""

from dataclasses import dataclass

import numpy as np

from . import changes


@dataclass(frozen=True)
class Wanted:
    """What a viewport should show; equal keys give equal pictures."""

    key: tuple
    view: object  # stages.View
    scene: changes.Scene
    options: object  # native Options
    backend: object


@dataclass(frozen=True)
class Picture:
    """A picture that is shown or about to be."""

    wanted: Wanted
    quality: int  # index of budget.QUALITIES
    image: object  # stages.Image, later a gpu_viewport.Picture


def seen(view):
    """A View as a tuple that can be compared."""
    return tuple(value.tobytes() if isinstance(value, np.ndarray) else value for value in vars(view).values())
