# SPDX-License-Identifier: GPL-3.0-or-later
"""Registers what a module of the add-on gives Blender: the classes that it defines, in the order of its file, entries
of menus, and what its own functions `register` and `unregister` add, if it has them."""

import bpy


def classes_of(module):
    """The Blender classes that a module defines, except render engines, which gpu_context.py registers, and tools,
    which are no classes to Blender."""
    defined = [cls for cls in vars(module).values() if isinstance(cls, type) and cls.__module__ == module.__name__]
    others = bpy.types.RenderEngine, bpy.types.WorkSpaceTool
    return [cls for cls in defined if issubclass(cls, bpy.types.bpy_struct) and not issubclass(cls, others)]


def register(module):
    """Registers a module's classes and its MENUS, {name of a menu: function that draws entries at its end}."""
    for cls in classes_of(module):
        bpy.utils.register_class(cls)
    for menu, draw in getattr(module, "MENUS", {}).items():
        getattr(bpy.types, menu).append(draw)
    if hasattr(module, "register"):
        module.register()


def unregister(module):
    """Undoes `register`, in reverse order."""
    if hasattr(module, "unregister"):
        module.unregister()
    for menu, draw in getattr(module, "MENUS", {}).items():
        getattr(bpy.types, menu).remove(draw)
    for cls in reversed(classes_of(module)):
        bpy.utils.unregister_class(cls)
