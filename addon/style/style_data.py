# SPDX-License-Identifier: GPL-3.0-or-later
"""Styles as datablocks: node trees that hold a style's properties and its response curves. Scenes point to them.

A scene that points to none draws the default style. Scripts say `use(scene, "charcoal")`, or a Style, and change what
they get.
"""

import hashlib

import bpy

from .. import style
from ..focus import focus_settings
from ..scene.line_kinds import definitions
from . import style_read, style_write


def is_style(tree):
    """Whether a node tree, or None, holds a style."""
    return tree is not None and tree.fovea.schema > 0


def of(scene):
    """The node tree of a scene's style; None: it draws the default."""
    tree = scene.fovea.style
    return tree if is_style(tree) else None


def new(name, wanted):
    """A node tree that holds a Style."""
    tree = bpy.data.node_groups.new(name, "ShaderNodeTree")
    style_write.write(tree, wanted)
    tree.fovea.untouched = fingerprint(tree)
    return tree


def default():
    """The Style of scenes that point to none."""
    return style.load(style.DEFAULT)


def use(scene, wanted, name="Style"):
    """Makes a scene draw with a Style, or with the shipped one of a name, in a datablock of its own: its properties."""
    if isinstance(wanted, str):
        wanted, name = style.load(wanted), title(wanted)
    assign(scene, new(name, wanted), wanted.focus)
    return scene.fovea.style.fovea


def own(scene):
    """The properties of the style that a scene draws with; a scene that has none gets the default as its own."""
    return of(scene).fovea if of(scene) else use(scene, style.DEFAULT)


def assign(scene, tree, focus=None):
    """Makes a scene draw with the style in a node tree, and look where a Focus says, if it says so. The one before goes
    where it is as it was made, and nobody else has it."""
    old = of(scene)
    scene.fovea.style = tree
    if focus is not None and focus.active():
        focus_settings.set_focus(scene.fovea, focus)
    if old and old != tree and is_spare(old):
        bpy.data.node_groups.remove(old)


def is_spare(tree):
    """Whether nothing is lost with it."""
    bare = not (tree.users or tree.library or tree.animation_data or tree.asset_data)
    return bare and tree.fovea.elision.density_image is None and tree.fovea.untouched == fingerprint(tree)


def fingerprint(tree):
    """Of all that its style says."""
    return hashlib.sha256(style.dump(style_read.read(tree)).encode()).hexdigest()


def note_source(tree, name):
    """Remembers the saved style that a style came from, or was saved as; a linked one is its own file's."""
    if tree.library is None:
        tree.fovea.source = name


def follow_source(name, fresh):
    """A saved style has another name: styles of this file that came from it know."""
    for tree in bpy.data.node_groups:
        if is_style(tree) and tree.fovea.source == name:
            note_source(tree, fresh)


_WORDS = {"and": "and", "xray": "X-Ray"}  # of file names, as they are written


def title(name):
    """A style's file name in words."""
    return " ".join(_WORDS.get(word, word.title()) for word in name.split("_"))


def choose_lines(held, names):
    """Makes a style, by its properties, draw the named kinds of lines and no others: each line set keeps those it has,
    and the last one has the rest."""
    *before, last = held.line_sets
    taken = set()
    for line_set in before:
        for definition in definitions():
            kind = definition["name"]
            on = getattr(line_set.kinds, kind) and kind in names
            setattr(line_set.kinds, kind, on)
            taken |= {kind} if on else set()
    for definition in definitions():
        setattr(last.kinds, definition["name"], definition["name"] in set(names) - taken)


def drawn_kinds(held):
    """Names of the kinds of lines that some line set of a style has."""
    kinds = (definition["name"] for definition in definitions())
    return {kind for kind in kinds if any(getattr(line_set.kinds, kind) for line_set in held.line_sets)}
