# SPDX-License-Identifier: GPL-3.0-or-later
"""The passes of a view layer: those that its panel lists are those that a file has."""

import itertools

import pytest
from pictures import box_scene, layered
from the_addon import part, use_style

session, style = part("render.session"), part("style")


@pytest.mark.parametrize("color, focus, depth", itertools.product([False, True], repeat=3))
def test_passes_that_are_listed_are_in_the_file(tmp_path, color, focus, depth):
    scene = box_scene()
    use_style(scene, "watercolor" if color else "plain")
    if focus:
        place = style.FocusPlace(at=(0.5, 0.5, 0.0), near=0.1, far=0.5)
        part("focus.focus_settings").set_focus(scene.fovea, style.Focus(model="image", points=(place,)))
    layer = scene.view_layers[0]
    layer.use_pass_z = depth
    wanted = session.wanted_passes(scene, layer)
    assert wanted == {"Lines": True, "Color": color, "Focus": focus, "Depth": depth}
    channels = layered(scene, tmp_path / "layers.exr")
    assert {name: any(f"{name}." in channel for channel in channels) for name in wanted} == wanted
