# SPDX-License-Identifier: GPL-3.0-or-later
"""Stands in for Blender's gpu module where programs are compiled: what they are declared with is recorded, and written
down as the GLSL that Blender's Vulkan back end makes of it."""

from types import SimpleNamespace

SAMPLERS = {"FLOAT_2D": "sampler2D", "UINT_2D": "usampler2D", "INT_2D": "isampler2D", "DEPTH_2D": "sampler2D"}
# Words that Blender's header defines away or otherwise: none may be a name in the sources.
HEADER = """#version 450
#define gl_VertexID gl_VertexIndex
#define gl_InstanceID gl_InstanceIndex
#define static
#define constant
#define device
#define thread
#define half float
#define select(a, b, mask) mix(a, b, mask)
"""
# Blender draws with depth from -1 to 1, and Vulkan from 0 to 1.
WRAPPED_MAIN = """void main_function_();
void main()
{
  main_function_();
  DEPTH_RANGE
}
#define main main_function_
"""


class Interface:
    """Records a GPUStageInterfaceInfo."""

    def __init__(self, _name):
        self.varyings = []  # (how it is interpolated, type, name)

    def smooth(self, kind, name):
        self.varyings.append(("smooth", kind, name))

    def flat(self, kind, name):
        self.varyings.append(("flat", kind, name))


class CreateInfo:
    """Records a GPUShaderCreateInfo, as Blender has it up to 4.3."""

    def __init__(self):
        self.inputs, self.varyings, self.outputs, self.samplers, self.constants = [], [], [], [], []
        self.defines, self.depth, self.vertex, self.fragment = [], None, None, None

    def vertex_in(self, slot, kind, name):
        self.inputs.append((slot, kind, name))

    def vertex_out(self, interface):
        self.varyings += interface.varyings

    def fragment_out(self, slot, kind, name):
        self.outputs.append((slot, kind, name))

    def sampler(self, slot, kind, name):
        self.samplers.append((slot, kind, name))

    def push_constant(self, kind, name):
        self.constants.append((kind, name))

    def define(self, name, value=""):
        self.defines.append((name, value))

    def vertex_source(self, text):
        self.vertex = text

    def fragment_source(self, text):
        self.fragment = text


class LaterCreateInfo(CreateInfo):
    """The same, as later Blenders have it."""

    def depth_write(self, value):
        self.depth = f"depth_{value.lower()}"


def module(create_info):
    """A module `gpu` whose shaders are the records that they are created from."""
    return SimpleNamespace(
        types=SimpleNamespace(GPUShaderCreateInfo=create_info, GPUStageInterfaceInfo=Interface),
        shader=SimpleNamespace(create_from_info=lambda info: info),
        platform=SimpleNamespace(backend_type_get=lambda: "VULKAN"),
    )


def stages(info, *, macros):
    """{stage: GLSL} of a record, for the stages vert and frag. `macros`: push constants are macros, as in Blender 4.2
    to 5.0; else they are members of a block without name, as in 5.2."""
    common = HEADER + "".join(f"#define {name} {value}\n" for name, value in info.defines)
    common += "".join(f"layout(binding = {i}) uniform {SAMPLERS[kind]} {name};\n" for i, kind, name in info.samplers)
    common += _constants(info.constants, macros)
    return {
        "vert": common + _vertex(info) + _main("gl_Position.z = (gl_Position.z + gl_Position.w) * 0.5;") + info.vertex,
        "frag": common + _fragment(info) + _main("") + info.fragment,
    }


def _constants(constants, macros):
    if not constants:
        return ""
    prefix = "pc_" if macros else ""
    members = "".join(f"  {kind.lower()} {prefix}{name};\n" for kind, name in constants)
    block = f"layout(push_constant, std430) uniform constants\n{{\n{members}}}"
    if not macros:
        return f"{block};\n"
    return f"{block} PushConstants;\n" + "".join(f"#define {n} (PushConstants.pc_{n})\n" for _, n in constants)


def _vertex(info):
    inputs = (f"layout(location = {slot}) in {kind.lower()} {name};\n" for slot, kind, name in info.inputs)
    return "".join(inputs) + _varyings(info, "out")


def _fragment(info):
    depth = f"layout({info.depth}) out float gl_FragDepth;\n" if info.depth else ""
    outputs = (f"layout(location = {slot}) out {kind.lower()} {name};\n" for slot, kind, name in info.outputs)
    return _varyings(info, "in") + depth + "".join(outputs)


def _varyings(info, way):
    described = enumerate(info.varyings)
    return "".join(f"layout(location = {i}) {way} {how} {kind.lower()} {name};\n" for i, (how, kind, name) in described)


def _main(depth_range):
    return WRAPPED_MAIN.replace("DEPTH_RANGE", depth_range)
