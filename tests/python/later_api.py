# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender's API has only since a version after 4.2, of all that the project uses or might use, with its guards.
From the change logs of Blender's Python API, and from comparing all types, operators and modules of 4.3 and 5.2."""

import ast
import re
from dataclasses import dataclass
from typing import NamedTuple


@dataclass(frozen=True)
class Later:
    use: str  # pattern of a whole expression, a whole text in quotes, or `name=` of an argument
    since: tuple  # version of Blender
    guard: str  # pattern of which something stands in the same function, or the same statement of a module
    there: str  # expression for whether this Blender has it, as "name in properties('Type')"
    until: tuple = (99,)  # the version in which it is gone again


ACTION_SLOT = r'(has|get)attr\(data, "action_slot"'
PENCIL = r"\bneed\(|pencils\.(need|are_there|kept)\(|version < \(4, 3"
LATER = (
    Later(r".*\.grease_pencils_v3|'grease_pencils_v3'", (4, 3), r'hasattr\(bpy\.data, "grease_pencils_v3"\)',
          "hasattr(bpy.data, 'grease_pencils_v3')", until=(5, 0)),
    Later(r".*\.grease_pencils", (4, 3), PENCIL, "hasattr(bpy.types, 'GreasePencilDrawing')"),
    Later(r".*\.new\(.*\)\.drawing", (4, 3), PENCIL, "hasattr(bpy.types, 'GreasePencilDrawing')"),
    Later(r".*\.add_strokes", (4, 3), PENCIL, "'add_strokes' in functions('GreasePencilDrawing')"),
    Later(r"'GREASEPENCIL'", (4, 3), PENCIL + '|"GPENCIL"', "'GREASEPENCIL' in items('Object', 'type')"),
    Later(r"'LINEART'", (4, 3), PENCIL + r"|modifier\.type|other\.type", "'LINEART' in items('Modifier', 'type')"),
    Later(r"'GREASE_PENCIL_(THICKNESS|OPACITY)'", (4, 3), "^ALONG = ",  # compared with what there is
          "'GREASE_PENCIL_OPACITY' in items('Modifier', 'type')"),
    Later(r".*\.add_curves", (4, 3), r"stage\.need\(\(4, 3\)", "'add_curves' in functions('Curves')"),
    Later(r".*\.register_preset_path", (4, 3), "hasattr|version <", "hasattr(bpy.utils, 'register_preset_path')"),
    Later(r".*\.template_asset_shelf_popover", (4, 3), "hasattr|version <",
          "'template_asset_shelf_popover' in functions('UILayout')"),
    Later(r".*handlers\.blend_import_(pre|post)", (4, 3), "hasattr|version <",
          "hasattr(bpy.app.handlers, 'blend_import_pre')"),
    Later(r".*\.action_slot", (4, 4), ACTION_SLOT, "'action_slot' in properties('AnimData')"),
    Later(r".*\baction\.slots", (4, 4), ACTION_SLOT, "'slots' in properties('Action')"),
    Later(r".*\.channelbag", (4, 4), ACTION_SLOT, "'channelbag' in functions('ActionKeyframeStrip')"),
    Later(r"modifier\.radius", (4, 5), r'hasattr\(modifier, "radius"\)',
          "'radius' in properties('GreasePencilLineartModifier')"),
    Later(r"'wm\.fbx_import'", (4, 5), r'"import_scene\.fbx"', "'fbx_import' in dir(bpy.ops.wm)"),
    Later(r"data\.exposure", (4, 4), r'getattr\(data, "exposure"', "'exposure' in properties('Light')"),
    Later(r".*\.media_type", (5, 0), '"media_type" in .*properties',
          "'media_type' in properties('ImageFormatSettings')"),
    Later(r"how\['pack'\]|pack=", (5, 0), r"version >= \(5, 0", "bpy.app.version >= (5, 0)"),
    Later(r"'freestyle_edge'", (5, 0), '"use_freestyle_mark" (not )?in .*properties',
          "'use_freestyle_mark' not in properties('MeshEdge')"),
    Later(r"'BLENDER_EEVEE'", (5, 0), '"BLENDER_EEVEE_NEXT"', "'BLENDER_EEVEE_NEXT' not in engines()"),
    Later(r".*\.compositing_node_group", (5, 0), r"hasattr|version|\bGROUPS\b",
          "'compositing_node_group' in properties('Scene')"),
    Later(r"[gs]et_transform=", (5, 0), "version <", "'get_transform' in bpy.props.BoolProperty.__doc__"),
    Later(r".*texture\.(filter_mode|extend_mode)", (5, 0), "hasattr|version <",
          "hasattr(__import__('gpu').types.GPUTexture, 'filter_mode')"),
    Later(r".*\.depth_write", (5, 0), r'hasattr\(info, "depth_write"\)',
          "hasattr(__import__('gpu').types.GPUShaderCreateInfo, 'depth_write')"),
    Later(r"gpu\.init", (5, 2), r'hasattr\(gpu, "init"\)', "hasattr(__import__('gpu'), 'init')"),
)  # fmt: skip


class Use(NamedTuple):
    text: str
    line: int
    around: str  # source of the function or the module's statement that it stands in


def uses(source):
    """Every attribute, subscript, argument's name, and text that stands for itself in a Python source, as a Use."""
    tree = ast.parse(source)
    for outer in tree.body:
        yield from _uses_in(outer, ast.get_source_segment(source, outer), source)


def _uses_in(node, around, source):
    if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
        inner = node.body[1:] if ast.get_docstring(node) else node.body
        inner = [*inner, *(node.args.defaults if isinstance(node, ast.FunctionDef) else ())]
        for each in inner:
            scope = ast.get_source_segment(source, node if isinstance(node, ast.FunctionDef) else each)
            yield from _uses_in(each, scope, source)
        return
    if isinstance(node, (ast.Attribute, ast.Subscript)):
        yield Use(ast.unparse(node), node.lineno, around)
    elif isinstance(node, ast.keyword) and node.arg:
        yield Use(f"{node.arg}=", node.value.lineno, around)
        if node.arg == "icon":  # names of pictures, which are as old as the types that they show
            return
    elif isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield Use(repr(node.value), node.lineno, around)
    for child in ast.iter_child_nodes(node):
        yield from _uses_in(child, around, source)


def unguarded(source, name):
    """A sentence for each use of what came later that stands without its guard."""
    for use in uses(source):
        for later in LATER:
            if re.fullmatch(later.use, use.text) and not re.search(later.guard, use.around):
                version = ".".join(map(str, later.since))
                yield f"{name}:{use.line}: {use.text} is there from Blender {version} on, and nothing guards it"
