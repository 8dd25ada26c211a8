# SPDX-License-Identifier: GPL-3.0-or-later
"""Overrides of lines by objects and materials: kinds, the crease angle, no lines at all."""

import math

import bpy
import numpy as np
from pairs import instanced, pair, sides, striped  # noqa: F401 (fixtures)
from pictures import drawn, ink
from the_addon import lines_of, only_lines, own_style, part


def test_a_material_without_lines_keeps_those_it_shares(striped, tmp_path):
    scene = striped
    bpy.data.materials["Blue"].fovea.lines = False
    assert sides(scene, tmp_path) == (True, False)
    lines_of(scene).material = "Blue"
    assert sides(scene, tmp_path) == (False, False)
    lines_of(scene).material = ""
    only_lines(scene, "material_boundary")
    assert ink(drawn(scene, tmp_path / "shared.png")).max() > 0.5
    bpy.data.materials["Red"].fovea.lines = False
    assert ink(drawn(scene, tmp_path / "none.png")).max() < 0.1


def test_an_object_has_its_own_kinds(pair, tmp_path):
    scene, _left = pair
    bpy.data.objects["Left"].rotation_euler = (0.3, 0.4, 0.0)  # what is seen edge on has no clear contour
    mine = bpy.data.objects["Left"].fovea
    whole = drawn(scene, tmp_path / "whole.png")
    mine.kinds.crease = False
    assert np.array_equal(drawn(scene, tmp_path / "off.png"), whole), "the switch is off"
    mine.own_kinds = True
    assert sides(scene, tmp_path) == (False, True)
    mine.kinds.crease, mine.kinds.contour = True, False
    assert np.array_equal(drawn(scene, tmp_path / "crease.png"), whole), "contours are not drawn anyway"
    part("style.style_data").choose_lines(own_style(scene), ("crease", "contour"))
    mine.kinds.crease, mine.kinds.contour = False, True
    assert sides(scene, tmp_path) == (True, True), "its contours are creases, too: they stay"


def test_an_object_has_its_own_crease_angle(pair, tmp_path):
    scene, _left = pair
    mine = bpy.data.objects["Left"].fovea
    mine.crease_angle = math.radians(100)
    assert sides(scene, tmp_path) == (True, True)
    mine.own_crease_angle = True
    assert sides(scene, tmp_path) == (False, True)
    lines_of(scene).kinds.crease_angle = math.radians(100)
    mine.crease_angle = math.radians(80)
    assert sides(scene, tmp_path) == (True, False)


def test_instances_have_the_lines_of_what_they_are_copies_of(pair, tmp_path):
    scene, _left = pair
    instanced(scene, bpy.data.collections.new("Source"))
    bpy.data.objects["Maker"].fovea.own_kinds = True
    bpy.data.objects["Maker"].fovea.kinds.crease = False
    assert sides(scene, tmp_path) == (True, True)
    mine = bpy.data.objects["Instanced"].fovea
    mine.own_kinds, mine.kinds.crease = True, False
    assert sides(scene, tmp_path) == (True, False)
    mine.own_kinds, mine.own_crease_angle, mine.crease_angle = False, True, math.radians(100)
    assert sides(scene, tmp_path) == (True, False)
