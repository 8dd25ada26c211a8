"""The line definitions and their parameters, as the native registry has them: the one place they are declared.

A definition is a dict of name, label, source (the paper), description, view_dependent and parameters; a parameter a dict
of name, default, min, max, unit and meaning. An edge may be of several kinds; the order is that of the registry.
"""

import functools

from . import native


@functools.cache
def definitions():
    """All line definitions, in the registry's order."""
    return tuple(native.load().line_definitions())


def defaults(name):
    """{parameter: default} of one line definition."""
    definition = next(d for d in definitions() if d["name"] == name)
    return {parameter["name"]: parameter["default"] for parameter in definition["parameters"]}
