# SPDX-License-Identifier: GPL-3.0-or-later
"""The gallery: the picture of the scene's style, which opens those of all styles; a click on one applies that style.

Blender's buttons show pictures at the size of icons only; this is the one widget whose pictures can be clicked."""

import bpy

from .. import style
from ..style import style_data, style_files
from .thumbnails import icon_of

SCALE, SCALE_OF_ALL = 7.0, 6.0  # size of the picture in panels, and of each that it opens
OWN = "FOVEA_OWN"  # item for a style that is none of the gallery

_kept = {}  # (names, icons) -> enum items: Blender keeps no references to their words, even while it shows them


def _listed(_manager, _context):
    """Items: the styles that ship and the user's; the scene's own one, too, if it comes from none of them."""
    wanted = [(name, style_data.title(name), icon_of(name)) for name in style_files.names()]
    if _current() == OWN:
        wanted.append((OWN, style_data.of(bpy.context.scene).name, "NODETREE"))
    return _kept.setdefault(tuple(wanted), [_item(i, *words) for i, words in enumerate(wanted)])


def _item(number, name, title, icon):
    told = "The style of this scene" if name == OWN else f"Draw the scene in {title}; an edited style stays in the file"
    return name, title, told, icon, number


def _current():
    """Name of the style that the scene's own came from; OWN if that is not in the gallery."""
    tree = style_data.of(bpy.context.scene)
    if tree is None:
        return style.DEFAULT
    return tree.fovea.source if tree.fovea.source in style_files.names() else OWN


def _shown(_manager):
    names = style_files.names()
    current = _current()
    return names.index(current) if current in names else len(names)


def _choose(_manager, number):
    names = style_files.names()
    if number < len(names):
        bpy.ops.fovea.style_apply("EXEC_DEFAULT", True, style=names[number])


def draw_gallery(layout, context):
    layout.template_icon_view(
        context.window_manager, "fovea_gallery", show_labels=True, scale=SCALE, scale_popup=SCALE_OF_ALL
    )


def register():
    bpy.types.WindowManager.fovea_gallery = bpy.props.EnumProperty(
        name="Gallery",
        description="Choose the style of the scene by its picture",
        items=_listed,
        get=_shown,
        set=_choose,
        options={"SKIP_SAVE"},
    )


def unregister():
    del bpy.types.WindowManager.fovea_gallery
