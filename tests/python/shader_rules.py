# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules of shader programs that all back ends of Blender's gpu module compile: OpenGL, Vulkan and Metal. On Vulkan, for
example, push constants are macros in Blender 4.2 to 5.0: a parameter of the same name is none there."""

import ast
import re
from dataclasses import dataclass

import shader_words as words

MOST_BYTES = 128  # of push constants: so many all Vulkan drivers have
MOST_SAMPLERS = 16
SIZES = {"FLOAT": 4, "INT": 4, "UINT": 4, "VEC2": 8, "IVEC2": 8, "UVEC2": 8, "VEC4": 16, "IVEC4": 16, "UVEC4": 16}
SIZES["MAT4"] = 64
SAMPLERS = {"FLOAT_2D", "UINT_2D", "INT_2D", "DEPTH_2D"}
TOKEN = re.compile(r"\w+|[^\w\s]")
FORMAT = re.compile(r"(R|RG|RGB|RGBA)\d+(F|UI|I)?$|DEPTH\w*$|R11\w+$|SRGB\w*$")


@dataclass(frozen=True)
class Program:
    """A program of programs.toml and the sources of its two stages."""

    name: str
    description: dict
    vertex: str
    fragment: str

    def names(self, *groups):
        return [name for group in groups for name in self.description.get(group, {})]

    def stages(self):
        """(stage, source, names that it gets from outside) of both stages."""
        both = self.names("smooth", "flat", "samplers", "constants")
        yield "vertex", self.vertex, [*both, *self.names("inputs")]
        yield "fragment", self.fragment, [*both, *self.names("outputs")]


def violations(program):
    """Sentences about what a program has that some back end does not compile, or lays out otherwise."""
    found = [*_of_description(program), *_of_names(program)]
    for stage, source, outside in program.stages():
        found += [f"its {stage} stage {sentence}" for sentence in _of_source(source, outside)]
    return [f"{program.name}: {sentence}" for sentence in found]


def _of_description(program):
    said = program.description
    for name, kind in said.get("constants", {}).items():
        if kind not in SIZES:
            yield f"the constant {name} is {kind}, which back ends pad differently: use one, two or four numbers"
    if (size := push_constant_bytes(said.get("constants", {}))) > MOST_BYTES:
        yield f"its constants have {size} bytes, more than the {MOST_BYTES} of push constants: use a uniform buffer"
    for name, kind in said["outputs"].items():
        if kind not in SIZES or kind == "MAT4":
            yield f"the output {name} is {kind}: no texture of three channels can be drawn into"
    for name, kind in said.get("samplers", {}).items():
        if kind not in SAMPLERS:
            yield f"the sampler {name} is {kind}, and not every back end has that"
    if len(said.get("samplers", {})) > MOST_SAMPLERS:
        yield f"it has more than {MOST_SAMPLERS} samplers, which Metal does not"
    for name in program.names("inputs", "smooth", "flat"):
        kind = {**said["inputs"], **said.get("smooth", {}), **said.get("flat", {})}[name]
        if kind.startswith("MAT"):
            yield f"{name} is {kind}, which takes several slots: use vectors"
    for name, kind in said.get("smooth", {}).items():
        if kind.startswith(("U", "I")):
            yield f"{name} is {kind}, and integers cannot be interpolated: it is flat"


def push_constant_bytes(constants):
    """Bytes of push constants in their order, by the layout std430; types that are none count as the largest vector."""
    end = 0
    for kind in constants.values():
        size = SIZES.get(kind, 16)
        align = min(size, 16)
        end = -(-end // align) * align + size
    return end


def _of_names(program):
    groups = ("inputs", "smooth", "flat", "outputs", "samplers", "constants")
    names = program.names(*groups)
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield f"{name} is declared twice"
    for name in dict.fromkeys(names):
        if reason := _why_no_name(name):
            yield f"{name} is no name: {reason}"
        if words.SWIZZLE.fullmatch(name):
            yield f"{name} is no name: it would be replaced in what follows a vector's dot"
    for name in program.description.get("defines", ()):
        if name != name.upper() or name in words.RESERVED:
            yield f"the define {name} is no word of capitals of its own"


def _why_no_name(name):
    """Why a name cannot be used in the sources; None if it can."""
    if name in words.RESERVED:
        return "it is a word of GLSL, Metal or HLSL, or of Blender's own"
    if name.startswith(words.BLENDERS_PREFIXES) or "__" in name:
        return "names that begin so are Blender's or the languages'"
    return None


def _of_source(source, outside):
    """Sentences about the source of a stage. `outside`: names that it gets from the program."""
    code = without_comments(source)
    for directive in re.findall(r"^\s*#\s*(\w+)", code, re.MULTILINE):
        if directive not in ("ifdef", "ifndef", "else", "endif"):
            yield f"has #{directive}, which is Blender's: programs.toml has defines"
    tokens = TOKEN.findall(re.sub(r"^\s*#.*$", "", code, flags=re.MULTILINE))
    for word in dict.fromkeys(tokens):
        if word in words.FORBIDDEN:
            yield f"has the word {word}: {words.FORBIDDEN[word]}"
        if word.startswith("gl_") and word not in words.BUILT_IN:
            yield f"uses {word}, which not every back end has"
    if re.search(r"\b(\w+)\s*\[\s*\d*\s*\]\s*\(", code):
        yield "makes an array of values, which Metal cannot: fill it in a loop"
    if re.search(r"\d(lf|LF)\b", code):
        yield "has a number of type double"
    for name, where in dict.fromkeys(declared(tokens)):
        if name in outside:
            yield f"declares {name}, which comes from outside: on Vulkan that is another word"
        elif reason := _why_no_name(name):
            if name != "main":
                yield f"declares {name}: {reason}"
        elif where == "global":
            yield f"has the variable {name} outside of functions, which Metal has not"


def without_comments(source):
    return re.sub(r"/\*.*?\*/|//[^\n]*", "", source, flags=re.DOTALL)


def declared(tokens):
    """(name, "global" or "local") of all that tokens of GLSL declare: structs, their members, functions, parameters and
    variables. Functions and structs count as local, as they may stand outside of functions."""
    structs = {tokens[i + 1] for i, word in enumerate(tokens) if word == "struct"}
    types, depth = words.TYPES | structs, 0
    for i, word in enumerate(tokens):
        depth += (word in "{(") - (word in "})")
        following = tokens[i + 1 : i + 3]
        if word == "struct":
            yield following[0], "local"
        elif word in types and following and re.match(r"[A-Za-z_]", following[0]):
            where = "global" if depth == 0 and following[1:] != ["("] else "local"
            yield from ((name, where) for name in _listed(tokens, i + 1, types))


def _listed(tokens, at, types):
    """Names of a declaration whose first one stands at `at`: x in `x = f(a, b), y;` and y."""
    yield tokens[at]
    depth = 0
    for i in range(at + 1, len(tokens)):
        word = tokens[i]
        depth += (word in "([{") - (word in ")]}")
        if word == ";" or depth < 0 or word == "{":
            return
        if word == "," and depth == 0:
            if tokens[i + 1] in types:
                return  # the next parameter
            yield tokens[i + 1]


def texture_formats(code):
    """Formats of textures that Python code names."""
    constants = (node.value for node in ast.walk(ast.parse(code)) if isinstance(node, ast.Constant))
    return [value for value in constants if isinstance(value, str) and FORMAT.match(value)]
