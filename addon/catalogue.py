# SPDX-License-Identifier: GPL-3.0-or-later
"""The line definitions and their parameters, read from the native registry, which declares them.

A definition is a dict of
- name, label, source (the paper), description
- scope (surface, view or scene: what its lines depend on) and view_dependent
- in_image: whether it is detected in the shaded image; such lines belong to no object
- importance, in (0, 1]: a term of the priority in elision
- smooth_twin: name of the counterpart on the smooth surface, which takes precedence over this mesh definition; or None
- of_smooth: whether line sets that suit lines to surfaces draw it on smooth ones alone
- slow: extraction is slow for each view, so drafts omit it
- stand_ins: {definition: {parameter: value}} that drafts draw instead, only along an object's outer silhouette
- reads_edge_marks: whether it needs Freestyle's edge marks, which are read only on demand
- usual: what artists draw with; panels fold the others
- parameters: dicts of name, label, default, min, max, unit ("degrees", "pixels", "millimeters", "bool" or
  ""), meaning, and
  per_object: whether objects may override the value
- file: None, or a dict of name, label, suffix, meaning of the file without which it finds nothing.
Definitions are in the registry's order.
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
    """All (definition, parameter) that objects may override."""
    return tuple((d, parameter) for d in definitions() for parameter in d["parameters"] if parameter["per_object"])


def read_edge_marks(line_sets):
    """Whether any of the LineSets has a kind that reads Freestyle's edge marks."""
    return any(by_name()[kind]["reads_edge_marks"] for line_set in line_sets for kind in line_set.kinds)


def named(words):
    """Checked names of definitions: the words themselves, or all names for ["all"]. ValueError on an unknown name."""
    known = list(by_name())
    if list(words) == ["all"]:
        return known
    for word in words:
        if word not in known:
            raise ValueError(f"there is no line definition '{word}'; there are: {', '.join(known)}; or all")
    return list(words)
