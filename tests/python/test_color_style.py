# SPDX-License-Identifier: GPL-3.0-or-later
"""Color and paper in style files."""

import pytest

from addon import style

LINES = '"line_sets": [{"kinds": {"contour": {}}}]'


def parsed(extra):
    return style.parse(f'{{"schema": 1, {extra}, {LINES}}}')


def test_without_a_word_nothing_is_colored():
    plain = style.parse(f'{{"schema": 1, {LINES}}}')
    assert plain.color == style.Color() and plain.color.shading == "plain"
    assert plain.paper == style.Paper() and plain.paper.texture == "none"


def test_all_of_it_goes_round():
    words = """"paper": {"texture": "rough", "scale": 1.5, "tooth": 0.5, "granulation": 0.25, "tint": 0.1},
        "color": {"shading": "toon", "bands": 4, "opacity": 0.5, "desaturation": 0.25, "background": [0.1, 0.2, 0.3]}"""
    chosen = parsed(words)
    assert chosen.color == style.Color(
        shading="toon", bands=4, opacity=0.5, desaturation=0.25, background=(0.1, 0.2, 0.3)
    )
    assert (chosen.paper.texture, chosen.paper.scale, chosen.paper.tooth) == ("rough", 1.5, 0.5)
    assert style.parse(style.dump(chosen)) == chosen
    assert parsed('"color": {"background": "paper"}').color == style.Color()
    assert style.parse(style.dump(parsed('"color": {"background": null}'))).color == style.Color()


@pytest.mark.parametrize(
    "words, sentence",
    [
        ('"color": {"shading": "phong"}', "color.shading is 'phong'; it can be: plain, flat, smooth, toon"),
        ('"color": {"shading": 3}', "color.shading must be text"),
        ('"color": {"bands": 1}', "color.bands is 1, outside 2 to 16"),
        ('"color": {"bands": true}', "color.bands must be a whole number"),
        ('"color": {"bands": 2.5}', "color.bands must be a whole number"),
        ('"color": {"opacity": 2}', "color.opacity is 2, outside 0 to 1"),
        ('"color": {"opacity": NaN}', "not JSON at line 1, column"),
        ('"color": {"background": "sky"}', "color.background must be 'paper' or a list of 3 numbers"),
        ('"color": {"background": [0, 1]}', "color.background must be 'paper' or a list of 3 numbers"),
        ('"color": {"background": [0, 1, -1]}', "color.background is -1, outside"),
        ('"color": []', "color must be a JSON object"),
        ('"paper": {"texture": "sandpaper"}', "paper.texture is 'sandpaper'; there are: none"),
        ('"paper": {"texture": "../styles/ink"}', "only letters, digits"),
        ('"paper": {"tooth": -0.1}', "paper.tooth is -0.1, outside 0 to 1"),
        ('"paper": {"scale": 0}', "paper.scale is 0, outside 0.1 to 20"),
        ('"paper": {"granulation": "much"}', "paper.granulation must be a number"),
    ],
)
def test_what_is_wrong_is_named(words, sentence):
    with pytest.raises(style.StyleError) as error:
        parsed(words)
    assert sentence in str(error.value)
