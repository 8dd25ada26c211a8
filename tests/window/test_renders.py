# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that start a render, in a real window."""


def test_operators_ask_a_render_beside_a_viewport(play):
    found = play("beside_a_viewport", file="render_scenarios.py")
    assert found["done"] == [True] * 3
    assert found["apart"] < 1e-3, "the viewport shows what it did"
    assert "'Far': is disabled in renders" in found["report"] and "objects and instances: 1," in found["report"]
    assert found["windows"] == 1, "no window opens for a render that shows nothing"
    assert found["engine"] == "BLENDER_WORKBENCH"
    assert found["strokes"] > 0 and not found["undone"]


def test_the_line_layer_is_shown_once_it_is_rendered(play):
    found = play("line_layer", file="render_scenarios.py")
    assert found["done"] and found["shown"] == ["Lines"], "in a window, as there is no image editor"
    assert found["again"] == ["Lines.001"] and found["windows"] == 2, "in the same one"


def test_lines_over_renders_are_one_click_and_f12_draws_them_as_a_script_does(play):
    found = play("lines_over", file="render_scenarios.py")
    assert found["done"] and found["lines"] > 0.3 and found["apart"] < 0.01
    assert found["in_step"], "a border of the scene is one of its lines at once"
    assert not found["left"] and found["scenes"] == 1 and found["engine"] == "BLENDER_WORKBENCH"
