# SPDX-License-Identifier: GPL-3.0-or-later
"""Shader programs, assembled as shaders/programs.toml describes. Compiling needs a GPU context."""

import gpu
import numpy as np

from .. import native
from . import manifest

LIMITS = ("ROW_WIDTH", "OWNER_STRIDE")  # constants of the core that are defined for the shader sources


def compile_program(name):
    """A new gpu.types.GPUShader of the named program; must not outlive the context it was created in."""
    description = manifest.programs()[name]
    info = gpu.types.GPUShaderCreateInfo()
    for slot, (attribute, kind) in enumerate(description.get("inputs", {}).items()):
        info.vertex_in(slot, kind, attribute)
    interface = gpu.types.GPUStageInterfaceInfo(f"fovea_{name}_interface")
    for varying, kind in description.get("smooth", {}).items():
        interface.smooth(kind, varying)
    for varying, kind in description.get("flat", {}).items():
        interface.flat(kind, varying)
    if "smooth" in description or "flat" in description:
        info.vertex_out(interface)
    for slot, (output, kind) in enumerate(description["outputs"].items()):
        info.fragment_out(slot, kind, output)
    for slot, (sampler, kind) in enumerate(description.get("samplers", {}).items()):
        info.sampler(slot, kind, sampler)
    for constant, kind in description.get("constants", {}).items():
        info.push_constant(kind, constant)
    for word in description.get("defines", ()):
        info.define(word)
    for limit in LIMITS:
        info.define(limit, str(getattr(native.load().AtlasBatch, limit)))
    if description.get("writes_depth"):
        _declare_depth(info)
    info.vertex_source(manifest.source(description["vertex"]))
    info.fragment_source(manifest.source(description["fragment"]))
    return gpu.shader.create_from_info(info)


def _declare_depth(info):
    """Lets the fragment stage write gl_FragDepth. Blender 4.3 has no API to declare it; only OpenGL works without."""
    if hasattr(info, "depth_write"):
        info.depth_write("ANY")
    elif gpu.platform.backend_type_get() != "OPENGL":
        return
    info.define("WRITES_DEPTH")


class Programs:
    """Programs by name, compiled on first use; must not outlive the context."""

    def __init__(self):
        self._programs = {}
        self._cover = None

    def bind(self, name, samplers=None, **constants):
        """Binds a program with its textures and push constants: int, float, or a sequence of floats; matrices as 16
        floats in column-major order."""
        if name not in self._programs:
            self._programs[name] = compile_program(name)
        program = self._programs[name]
        program.bind()
        for sampler, texture in (samplers or {}).items():
            program.uniform_sampler(sampler, texture)
        for constant, value in constants.items():
            put = program.uniform_int if isinstance(value, int) else program.uniform_float
            put(constant, value)
        return program

    def cover(self, name, samplers, **constants):
        """Runs a program over every pixel of the bound target, with one triangle that covers it."""
        if self._cover is None:
            corners = np.array(((-1, -1), (3, -1), (-1, 3)), np.float32)
            self._cover = triangles({"corner": corners})
        self._cover.draw(self.bind(name, samplers, **constants))


def triangles(attributes, corners=None):
    """A GPUBatch of triangles. `attributes`: {name: array per vertex}; `corners`: (T, 3) vertex indices, None: each
    three consecutive vertices are a triangle."""
    words = {} if corners is None else {"elem": gpu.types.GPUIndexBuf(type="TRIS", seq=corners)}
    return gpu.types.GPUBatch(type="TRIS", buf=vertex_buffer(attributes), **words)


def vertex_buffer(attributes):
    """A vertex buffer; each attribute is an (n,) or (n, 1..4) array, uint32 if unsigned, else float32."""
    form = gpu.types.GPUVertFormat()
    arrays = {}
    for name, values in attributes.items():
        integer = values.dtype.kind == "u"
        arrays[name] = values = np.ascontiguousarray(values, np.uint32 if integer else np.float32)
        form.attr_add(
            id=name,
            comp_type="U32" if integer else "F32",
            len=1 if values.ndim == 1 else values.shape[1],
            fetch_mode="INT" if integer else "FLOAT",
        )
    buffer = gpu.types.GPUVertBuf(format=form, len=len(values))
    for name, values in arrays.items():
        buffer.attr_fill(id=name, data=values)
    return buffer
