# SPDX-License-Identifier: GPL-3.0-or-later
"""The line definitions and their parameters, as the native registry has them: the one place they are declared.

A definition is a dict of
- name, label, source (the paper), description
- scope (surface, view or scene: what its lines depend on) and view_dependent
- in_image: whether they are found in the shaded picture, and so are of no object
- importance, in (0, 1]: of lines that crowd each other the more important one stays
- smooth_twin: name of the same line of the smooth surface, which goes before this one of the mesh; or None
- slow: it takes long to find for each view, and drafts leave it out
- stand_ins: {definition: {parameter: value}} that drafts draw instead, where they are an object's outer boundary
- reads_edge_marks: whether it finds edges marked for Freestyle, which are read only where they are asked for
- parameters: dicts of name, label, default, min, max, unit ("degrees", "pixels", "bool" or ""), meaning, and
  per_object: objects may have a value of their own.
The order is that of the registry.
"""

import functools

from . import native


@functools.cache
def definitions():
    """All line definitions, in the registry's order."""
    return tuple(native.load().line_definitions())


@functools.cache
def by_name():
    """{name: definition}, in the registry's order."""
    return {definition["name"]: definition for definition in definitions()}


@functools.cache
def per_object():
    """(definition, parameter) of which objects may have values of their own."""
    return tuple((d, parameter) for d in definitions() for parameter in d["parameters"] if parameter["per_object"])


def read_edge_marks(line_sets):
    """Whether some LineSets have lines along edges that are marked for Freestyle."""
    return any(by_name()[kind]["reads_edge_marks"] for line_set in line_sets for kind in line_set.kinds)


def named(words):
    """Names of definitions: those given, or every one where the word is `all`. ValueError for what is none."""
    known = list(by_name())
    if list(words) == ["all"]:
        return known
    for word in words:
        if word not in known:
            raise ValueError(f"there is no line definition '{word}'; there are: {', '.join(known)}; or all")
    return list(words)
