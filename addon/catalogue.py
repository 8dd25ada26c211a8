# SPDX-License-Identifier: GPL-3.0-or-later
"""The line definitions and their parameters, as the native registry has them: the one place they are declared.

A definition is a dict of name, label, source (the paper), description, default (on or off), view_dependent, scope
(surface, view or scene: what its lines depend on), in_image (whether they are found in the shaded picture, and so are
of no object) and parameters; a parameter a dict of name, label, default, min, max, unit and meaning. The order is that
of the registry.
"""

import functools

from . import native


@functools.cache
def definitions():
    """All line definitions, in the registry's order."""
    return tuple(native.load().line_definitions())


def named(words):
    """Names of definitions: those given, or every one where the word is `all`. ValueError for what is none."""
    known = [definition["name"] for definition in definitions()]
    if list(words) == ["all"]:
        return known
    for word in words:
        if word not in known:
            raise ValueError(f"there is no line definition '{word}'; there are: {', '.join(known)}; or all")
    return list(words)
