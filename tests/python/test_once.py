# SPDX-License-Identifier: GPL-3.0-or-later
"""What several stages of a picture ask for is made once, and is the same as if each made its own."""

import json

import numpy as np
import pytest
from native_core import box, core, scene, view

from addon import emphasis, pipeline, stages, style
from addon.backend import cpu, cpu_focus

AWAY = {"pen": {"width": 3}, "pen_away": {"width": 3, "opacity": 0.1}}


@pytest.fixture
def asked(monkeypatch):
    """How often each of the two is made."""
    counted = {}
    for module, name in ((cpu, "depth_image"), (cpu_focus, "focus_of")):
        old = getattr(module, name)

        def counting(*words, name=name, old=old):
            counted[name] = counted.get(name, 0) + 1
            return old(*words)

        monkeypatch.setattr(module, name, counting)
    return counted


def drawn(model, **options):
    matrices = np.array([np.eye(4), np.eye(4)])
    matrices[0][0, 3], matrices[1][0, 3] = -2, 2
    placed, seen = scene([box().surface()] * 2, matrices), view((0, -12, 3), (0, 0, 0))
    focus = {"model": model, "points": [{"object": "A", "at": [-2, 0, 0], "near": 0.5, "far": 3}]}
    sets = [{"lines": {"contour": {}, "crease": {}}, **AWAY}]
    chosen = style.parse(json.dumps({"schema": style.SCHEMA, "line_sets": sets, "focus": focus}))
    beside = {"notes": stages.Notes(objects=(("A",), ("B",))), "progress": lambda *_: None, "cancel": core.Cancel()}
    image = pipeline.draw(placed, seen, chosen, cpu.Backend(), pipeline.Options(**options), **beside)
    frame = pipeline.Frame(placed, seen, core.Tracer(placed, seen), None, None, 1, 1, notes=beside["notes"])
    return image, frame, chosen


@pytest.mark.parametrize("model", ["object", "scene"])
def test_focus_and_depth_are_made_once(asked, model):
    image, _, _ = drawn(model, with_depth=True, with_focus=True)
    assert asked == {"depth_image": 1, "focus_of": 1}
    assert image.focus.min() < 0.5 and image.focus.max() == 1


def test_what_nobody_asks_for_is_not_made(asked):
    drawn("none")
    assert asked == {}


@pytest.mark.parametrize("model", ["object", "scene"])
def test_they_are_as_if_made_apart(model):
    image, frame, chosen = drawn(model, with_depth=True, with_focus=True)
    np.testing.assert_array_equal(image.depth, core.depth_image(frame.tracer))
    np.testing.assert_array_equal(image.focus, emphasis.of_pixels(frame, chosen, core.Cancel()))
    lines_alone, _, _ = drawn(model)
    assert lines_alone.depth is None and lines_alone.focus is None
    np.testing.assert_array_equal(image.lines, lines_alone.lines)
