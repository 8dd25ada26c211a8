# SPDX-License-Identifier: GPL-3.0-or-later
"""Styles as datablocks: node trees with a style's properties and response curves, to which scenes point.

A scene without one draws the default style. Scripts call `use(scene, "charcoal")`, or pass a Style, and modify the
properties it returns.
"""

import hashlib
from pathlib import Path

import bpy

from .. import style
from ..focus import focus_settings
from ..scene.line_kinds import definitions
from . import style_read, style_write


def is_style(tree):
    """Whether a node tree, or None, holds a style."""
    return tree is not None and tree.fovea.schema > 0


def of(scene):
    """The node tree of a scene's style; None if it draws the default."""
    tree = scene.fovea.style
    return tree if is_style(tree) else None


def new(name, wanted):
    """A new node tree with a Style."""
    tree = bpy.data.node_groups.new(name, "ShaderNodeTree")
    style_write.write(tree, wanted)
    tree.fovea.untouched = fingerprint(tree)
    return tree


def default():
    """The Style of scenes without a style datablock."""
    return style.load(style.DEFAULT)


def use(scene, wanted, name="Style"):
    """Assigns a Style, or that of a name or a file (style.named), to a scene as a new datablock; returns its
    properties."""
    if isinstance(wanted, str):
        wanted, name = style.named(wanted), title(Path(wanted).stem)
    assign(scene, new(name, wanted), wanted.focus)
    return scene.fovea.style.fovea


def own(scene):
    """The properties of a scene's style; a scene without one gets a new datablock with the default style."""
    return of(scene).fovea if of(scene) else use(scene, style.DEFAULT)


def assign(scene, tree, focus=None):
    """Assigns the style in a node tree to a scene, and the Focus to its settings if it is active. Removes the previous
    style if it is unmodified and has no other users."""
    old = of(scene)
    scene.fovea.style = tree
    if focus is not None and focus.active():
        focus_settings.set_focus(scene.fovea, focus)
    if old and old != tree and is_spare(old):
        bpy.data.node_groups.remove(old)


def is_spare(tree):
    """Whether a style can be removed without loss: unused, local, unmodified, not animated and not an asset."""
    bare = not (tree.users or tree.library or tree.animation_data or tree.asset_data)
    return bare and tree.fovea.elision.density_image is None and tree.fovea.untouched == fingerprint(tree)


def fingerprint(tree):
    """Hash of everything in a node tree's style."""
    return hashlib.sha256(style.dump(style_read.read(tree)).encode()).hexdigest()


def note_source(tree, name):
    """Stores the name of the saved style that a style came from or was saved as; not for linked styles."""
    if tree.library is None:
        tree.fovea.source = name


def follow_source(name, fresh):
    """Updates the stored source in this file's styles after a saved style was renamed."""
    for tree in bpy.data.node_groups:
        if is_style(tree) and tree.fovea.source == name:
            note_source(tree, fresh)


_WORDS = {"and": "and", "xray": "X-Ray"}  # words of file names that are not simply capitalized


def title(name):
    """A style's display name from its file name."""
    return " ".join(_WORDS.get(word, word.title()) for word in name.split("_"))


def choose_lines(held, names):
    """Restricts a style's properties to the named kinds of lines, on whatever surfaces: each line set keeps its kinds
    among them, but for those of smooth shapes, and the last one gets the named kinds that no other set has."""
    for line_set in held.line_sets:
        line_set.surfaces = "ALL"
    *before, last = held.line_sets
    taken = set()
    for line_set in before:
        for definition in definitions():
            kind = definition["name"]
            on = getattr(line_set.kinds, kind) and kind in names and not definition["of_smooth"]
            setattr(line_set.kinds, kind, on)
            taken |= {kind} if on else set()
    for definition in definitions():
        setattr(last.kinds, definition["name"], definition["name"] in set(names) - taken)


def drawn_kinds(held):
    """Names of the kinds of lines that any line set of a style has."""
    kinds = (definition["name"] for definition in definitions())
    return {kind for kind in kinds if any(getattr(line_set.kinds, kind) for line_set in held.line_sets)}
