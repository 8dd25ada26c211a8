# SPDX-License-Identifier: GPL-3.0-or-later
"""Shader programs compile for Vulkan as Blender hands them on, and SPIRV-Cross makes Metal's language of them."""

import importlib
import re
import shutil
import subprocess
import sys

import pytest
import recorded_gpu
from shader_rules import TOKEN, declared, without_comments

from addon.gpu import manifest

TOOLS = ("glslangValidator", "spirv-val", "spirv-cross")
pytestmark = pytest.mark.skipif(
    any(shutil.which(tool) is None for tool in TOOLS), reason="glslang-tools, spirv-tools or spirv-cross is missing"
)
BLENDERS = {  # of a generation: what programs are declared with, and whether push constants are macros
    "4.2": (recorded_gpu.CreateInfo, True),
    "5.0": (recorded_gpu.LaterCreateInfo, True),
    "5.2": (recorded_gpu.LaterCreateInfo, False),
}
STAGES = {"vert": "vertex", "frag": "fragment"}


@pytest.fixture(params=BLENDERS)
def blender(request, monkeypatch):
    """Compiles a program of the add-on as a generation of Blender does: {stage: GLSL}."""
    create_info, macros = BLENDERS[request.param]
    monkeypatch.setitem(sys.modules, "gpu", recorded_gpu.module(create_info))
    monkeypatch.delitem(sys.modules, "addon.gpu.program", raising=False)
    compile_program = importlib.import_module("addon.gpu.program").compile_program
    yield lambda name: recorded_gpu.stages(compile_program(name), macros=macros)
    sys.modules.pop("addon.gpu.program")


def run(*words):
    done = subprocess.run(words, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def spirv(folder, stage, text):
    """(file of the SPIR-V, what glslang and the validator say) of a stage's GLSL; nothing is said of what is right."""
    source, binary = folder / f"stage.{stage}", folder / f"{stage}.spv"
    source.write_text(text)
    code, told = run("glslangValidator", "-V", "--target-env", "vulkan1.2", "-o", str(binary), str(source))
    told = told.replace(str(source), "").strip()
    if code == 0:
        told += run("spirv-val", "--target-env", "vulkan1.2", str(binary))[1]
    return binary, told


def metal(binary):
    """(exit status, Metal's language) of a stage's SPIR-V."""
    return run("spirv-cross", str(binary), "--msl", "--msl-version", "20300")


def renamed(text, translated):
    """Names that a stage's source declares and that Metal has a use of its own for, so that they are others there."""
    names = {name for name, _ in declared(TOKEN.findall(without_comments(text)))} - {"main"}
    there = set(TOKEN.findall(translated))
    return sorted(name for name in names - there if {f"{name}0", f"{name}_0", f"_{name}", f"{name}_"} & there)


@pytest.mark.parametrize("name", manifest.programs())
def test_every_program_compiles_for_vulkan_and_metal(blender, name, tmp_path):
    said = manifest.programs()[name]
    for stage, text in blender(name).items():
        binary, told = spirv(tmp_path, stage, text)
        assert told == "", f"{stage}: {told}"
        status, translated = metal(binary)
        assert status == 0, translated
        assert re.search(rf"^{STAGES[stage]} \w+ main0\(", translated, re.MULTILINE)
        assert renamed(manifest.source(said[STAGES[stage]]), translated) == []


SIMPLE = {
    "inputs": [(0, "VEC2", "corner")],
    "varyings": [("smooth", "VEC2", "share")],
    "outputs": [(0, "VEC4", "color")],
    "samplers": [(0, "FLOAT_2D", "picture")],
    "constants": [("VEC2", "border"), ("FLOAT", "width_px")],
}
VERTEX = "void main() { gl_Position = vec4(corner, 0.0, 1.0); share = corner; }"


def told_of(tmp_path, fragment, *, macros):
    """What is said of a simple program with this fragment stage."""
    info = recorded_gpu.LaterCreateInfo()
    vars(info).update(SIMPLE, vertex=VERTEX, fragment=fragment)
    return spirv(tmp_path, "frag", recorded_gpu.stages(info, macros=macros)["frag"])


RIGHT = "float f(float at) { return at * width_px; }\nvoid main() { color = vec4(f(share.x)); }"


def test_a_simple_program_compiles(tmp_path):
    for macros in (True, False):
        binary, told = told_of(tmp_path, RIGHT, macros=macros)
        assert told == "" and metal(binary)[0] == 0


def test_a_parameter_with_the_name_of_a_constant_fails_where_constants_are_macros(tmp_path):
    shadowed = RIGHT.replace("float at", "float border")
    assert "syntax error" in told_of(tmp_path, shadowed, macros=True)[1]
    assert "undeclared identifier" in told_of(tmp_path, shadowed, macros=False)[1]  # `at`: else it would compile there


def test_a_warning_and_a_wrong_type_are_found(tmp_path):
    assert "ERROR" in told_of(tmp_path, RIGHT.replace("vec4(f(share.x))", "vec3(0.0)"), macros=False)[1]
    assert "WARNING" in told_of(tmp_path, f"#extension GL_nobody_has_this : enable\n{RIGHT}", macros=False)[1]


def test_a_name_that_metal_has_a_use_for_is_found(tmp_path):
    taken = RIGHT.replace("float f(float at) { return at", "float f(float kernel) { return kernel")
    binary, told = told_of(tmp_path, taken, macros=False)
    assert told == "" and renamed(taken, metal(binary)[1]) == ["kernel"]
    assert renamed(RIGHT, metal(told_of(tmp_path, RIGHT, macros=False)[0])[1]) == []
