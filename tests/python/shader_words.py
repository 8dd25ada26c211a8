# SPDX-License-Identifier: GPL-3.0-or-later
"""Words that name something in a language that Blender makes of a shader program, and so can be no name in its sources:
GLSL for OpenGL and Vulkan, Metal's C++, and HLSL."""

import re


def _words(text):
    return frozenset(text.split())


_SHAPES = ("", "2", "3", "4")
_MATRICES = [f"{rows}x{columns}" for rows in "234" for columns in "234"]
_NUMBERS = "float half bfloat int uint short ushort char uchar long ulong bool double fixed".split()

# Types that the sources may use.
TYPES = _words("void bool int uint float mat2 mat3 mat4 sampler2D usampler2D isampler2D") | {
    f"{prefix}vec{size}" for prefix in ("", "i", "u", "b") for size in "234"
}

GLSL = _words(
    """
    active asm attribute break buffer case cast centroid class coherent common const continue default discard do double
    else enum extern external false filter fixed flat for goto half if in inline inout input interface invariant layout
    long main namespace noinline noperspective out output packed partition patch precise precision public readonly
    resource restrict return sample sampler shared short sizeof smooth static struct subpassInput subroutine superp
    switch template this true typedef uniform union unsigned using varying volatile while writeonly highp mediump lowp
    texture image dvec2 dvec3 dvec4 hvec2 hvec3 hvec4 fvec2 fvec3 fvec4
    """
)

METAL = _words(
    """
    alignas alignof and and_eq as_type asm auto bitand bitor catch char compl concept constexpr const_cast constant
    decltype delete depth2d device dynamic_cast explicit export fragment friend intersection kernel level mesh metal
    mutable new noexcept not not_eq nullptr object object_data operator or or_eq private protected ptrdiff_t quad
    ray_data register reinterpret_cast signed simd simdgroup size_t static_assert static_cast std stitchable template
    texture1d texture2d texture3d texturecube thread thread_local threadgroup threadgroup_imageblock throw try typeid
    typename vec vertex virtual visible volatile wchar_t xor xor_eq access read write read_write
    """
)

# Without point, line and triangle, which mean something before inputs of geometry shaders alone.
HLSL = _words(
    """
    Buffer RWTexture2D SamplerState StructuredBuffer Texture2D asfloat asint asuint cbuffer column_major compile
    globallycoherent groupshared lineadj linear matrix nointerpolation numthreads packoffset pass pixelfragment
    row_major snorm stateblock string tbuffer technique triangleadj unorm vector vertexfragment
    """
)

# What Blender itself defines before the sources on some back end.
BLENDER = _words("RESHAPE ARRAY_T ARRAY_V PushConstants constants main_function_ string_t imageFence select as_uint")

# Functions of GLSL, and those of Metal and HLSL that Blender's headers or these languages have in its place.
FUNCTIONS = _words(
    """
    abs acos acosh all any asin asinh atan atan2 atanh ceil clamp clip cos cosh countbits cross ddx ddy degrees
    determinant dFdx dFdy distance dot dst equal exp exp2 faceforward fdim floatBitsToInt floatBitsToUint floor fma fmax
    fmin fmod frac fract frexp fwidth greaterThan greaterThanEqual imageLoad imageStore intBitsToFloat inverse
    inversesqrt isfinite isinf isnan isnormal ldexp length lerp lessThan lessThanEqual lit log log2 max min mix mod modf
    mul noise normalize notEqual outerProduct popcount pow powr precise radians rcp reflect refract rint round roundEven
    rsqrt saturate sign sin sincos sinh smoothstep sqrt step tan tanh texelFetch textureGather textureLod textureSize
    transpose trunc uintBitsToFloat
    """
)

_OTHER_TYPES = {f"{number}{size}" for number in _NUMBERS for size in (*_SHAPES, *_MATRICES)}
_OTHER_TYPES |= {f"{prefix}mat{shape}" for prefix in ("", "d") for shape in ("2", "3", "4", *_MATRICES)}

RESERVED = GLSL | METAL | HLSL | BLENDER | FUNCTIONS | TYPES | _OTHER_TYPES

# Words of the sources that do things which some back end cannot do, or does otherwise.
FORBIDDEN = {
    **dict.fromkeys(
        ("in", "out", "inout", "uniform", "varying", "attribute", "layout", "buffer", "shared", "precision"),
        "programs.toml declares what goes in and out, and parameters are handed on by value",
    ),
    **dict.fromkeys(("double", "dvec2", "dvec3", "dvec4", "dmat2", "dmat3", "dmat4"), "Metal has no doubles"),
    **dict.fromkeys(("switch", "goto"), "compilers differ in it: write if and else"),
    **dict.fromkeys(("mat3", "mat2"), "its columns are padded differently: use vectors, or mat4"),
    **dict.fromkeys(("const", "static"), "constants of files are not everywhere: write a define of programs.toml"),
}

# Built-in variables that all back ends have.
BUILT_IN = _words("gl_Position gl_FragCoord gl_FragDepth gl_VertexID gl_InstanceID")
BLENDERS_PREFIXES = ("gl_", "gpu_", "pc_", "_")
SWIZZLE = re.compile(r"[xyzw]{1,4}|[rgba]{1,4}|[stpq]{1,4}")

# Formats of textures that every GPU has, as targets, too.
FORMATS = _words("RGBA8 RGBA16F RGBA32F R32F R32UI R32I RG32F RG32UI DEPTH_COMPONENT32F")
