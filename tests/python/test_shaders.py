# SPDX-License-Identifier: GPL-3.0-or-later
"""Shader programs keep to what OpenGL, Vulkan and Metal have in common."""

from pathlib import Path

import pytest
from shader_rules import MOST_BYTES, Program, push_constant_bytes, texture_formats, violations
from shader_words import FORMATS

from addon.gpu import manifest

SIMPLE = {
    "inputs": {"corner": "VEC2"},
    "smooth": {"share": "VEC2"},
    "outputs": {"color": "VEC4"},
    "samplers": {"picture": "FLOAT_2D"},
    "constants": {"border": "VEC2", "width_px": "FLOAT"},
}
VERTEX = "void main() { gl_Position = vec4(corner, 0.0, 1.0); share = corner; }"
FRAGMENT = "void main() { color = texelFetch(picture, ivec2(share * width_px + border), 0); }"


def found(vertex="", fragment="", **changed):
    """Violations of a simple program with something before its stages, or in its description."""
    return violations(Program("simple", SIMPLE | changed, f"{vertex}\n{VERTEX}", f"{fragment}\n{FRAGMENT}"))


def test_a_simple_program_is_clean():
    assert found() == []


@pytest.mark.parametrize("name", manifest.programs())
def test_every_program_is_clean(name):
    said = manifest.programs()[name]
    assert violations(Program(name, said, manifest.source(said["vertex"]), manifest.source(said["fragment"]))) == []


SHADOWING = {
    "a parameter": "float f(float width_px) { return width_px; }",
    "a second parameter": "float f(float at, float width_px) { return at; }",
    "a variable": "float f() { float width_px = 1.0; return width_px; }",
    "a second variable": "float f() { vec2 at = vec2(1.0, 2.0), width_px = at; return at.x; }",
    "a variable of a loop": "float f() { for (int width_px = 0; width_px < 2; width_px++) {} return 1.0; }",
    "a member": "struct Place { vec2 at; float width_px; };",
    "a variable that is a struct": "struct Place { vec2 at; }; float f() { Place width_px; return 1.0; }",
    "a function": "float width_px() { return 1.0; }",
    "a struct": "struct width_px { vec2 at; };",
}


@pytest.mark.parametrize("case", SHADOWING)
@pytest.mark.parametrize("stage", ["vertex", "fragment"])
def test_what_has_the_name_of_a_constant_is_found(case, stage):
    (sentence,) = found(**{stage: SHADOWING[case]})
    assert sentence.startswith(f"simple: its {stage} stage declares width_px, which comes from outside")


@pytest.mark.parametrize(
    "stage, name", [("vertex", "corner"), ("fragment", "share"), ("fragment", "picture"), ("fragment", "color")]
)
def test_what_has_the_name_of_an_attribute_a_varying_a_sampler_or_an_output_is_found(stage, name):
    (sentence,) = found(**{stage: f"float f(float {name}) {{ return 1.0; }}"})
    assert f"declares {name}, which comes from outside" in sentence


def test_names_of_the_other_stage_are_free():
    assert found(vertex="float f(float color) { return color; }") == []
    assert found(fragment="float f(float corner) { return corner; }") == []


@pytest.mark.parametrize("name", "texture half float4 kernel thread constant cbuffer saturate select step not".split())
def test_a_word_of_another_language_is_no_name(name):
    assert [s for s in found(fragment=f"float f(float {name}) {{ return 1.0; }}") if f"declares {name}" in s]
    assert [s for s in found(constants={name: "FLOAT"}) if f"{name} is no name" in s]


@pytest.mark.parametrize("name", ["gpu_place", "gl_place", "pc_place", "_place", "my__place"])
def test_a_name_that_begins_as_those_of_blender_do_is_found(name):
    assert [s for s in found(fragment=f"float f(float {name}) {{ return 1.0; }}") if f"declares {name}" in s]
    assert [s for s in found(smooth={"share": "VEC2", name: "FLOAT"}) if f"{name} is no name" in s]


DESCRIPTIONS = {
    "a vector of three among the constants": ({"constants": {"sun": "VEC3"}}, "the constant sun is VEC3"),
    "whole numbers by threes": ({"constants": {"cell": "IVEC3"}}, "the constant cell is IVEC3"),
    "a matrix of three": ({"constants": {"turn": "MAT3"}}, "the constant turn is MAT3"),
    "constants that are too large": ({"constants": {"a": "MAT4", "b": "MAT4", "c": "FLOAT"}}, "have 132 bytes"),
    "a name twice": ({"constants": {"share": "FLOAT"}}, "share is declared twice"),
    "a name that vectors have": ({"constants": {"xy": "FLOAT"}}, "xy is no name"),
    "an image of three channels": ({"outputs": {"color": "VEC3"}}, "the output color is VEC3"),
    "a sampler of a kind that is rare": ({"samplers": {"picture": "FLOAT_1D"}}, "the sampler picture is FLOAT_1D"),
    "too many samplers": ({"samplers": {f"picture{i}": "FLOAT_2D" for i in range(17)}}, "more than 16 samplers"),
    "a matrix per vertex": ({"inputs": {"turn": "MAT4"}}, "turn is MAT4"),
    "an integer that is interpolated": ({"smooth": {"share": "UINT"}}, "share is UINT"),
    "a define in small letters": ({"defines": ["spine"]}, "the define spine"),
}


@pytest.mark.parametrize("case", DESCRIPTIONS)
def test_a_description_that_back_ends_lay_out_otherwise_is_found(case):
    changed, complaint = DESCRIPTIONS[case]
    assert [s for s in found(**changed) if complaint in s]


def test_push_constants_are_aligned_as_the_layout_std430_has_them():
    assert push_constant_bytes({}) == 0
    assert push_constant_bytes({"a": "FLOAT", "b": "VEC2", "c": "VEC4", "d": "INT"}) == 36
    assert push_constant_bytes({"a": "MAT4", "b": "FLOAT", "c": "INT"}) == 72
    assert max(push_constant_bytes(said.get("constants", {})) for said in manifest.programs().values()) <= MOST_BYTES


SOURCES = {
    "uniform float more;": "has the word uniform",
    "float f(inout float at) { return at; }": "has the word inout",
    "double f(float at) { return at; }": "has the word double",
    "float f(int at) { switch (at) { default: return 1.0; } }": "has the word switch",
    "mat3 f(float at) { return mat3(at); }": "has the word mat3",
    "const float more = 1.0;": "has the word const",
    "float more = 1.0;": "has the variable more outside of functions",
    "vec2 more, other;": "has the variable other outside of functions",
    "float f() { return float[2](1.0, 2.0)[0]; }": "makes an array of values",
    "float f() { return 1.0lf; }": "has a number of type double",
    "#define MORE 1": "has #define",
    "#extension GL_ARB_gpu_shader5 : enable": "has #extension",
    "int f() { return gl_BaseInstance; }": "uses gl_BaseInstance",
}


@pytest.mark.parametrize("source", SOURCES)
def test_a_source_that_some_back_end_does_not_compile_is_found(source):
    assert [s for s in found(fragment=source) if SOURCES[source] in s]


def test_comments_may_say_anything():
    assert found(fragment="// uniform double width_px;\n/* in out\n #define */") == []


def test_textures_have_formats_that_every_gpu_has():
    assert texture_formats('formats = ("RGB32F", "DEPTH24_STENCIL8", "GREATER")') == ["RGB32F", "DEPTH24_STENCIL8"]
    files = Path(manifest.__file__).parent.glob("*.py")
    named = {(file.name, name) for file in files for name in texture_formats(file.read_text())}
    assert {name for _, name in named} >= {"R32F", "RGBA32F"}
    assert [entry for entry in named if entry[1] not in FORMATS] == []
