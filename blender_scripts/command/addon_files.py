# SPDX-License-Identifier: GPL-3.0-or-later
"""Modules of the add-on that need neither Blender nor the rest of the add-on, loaded by their files: the package
`addon` is the staged one, with the native module, where it is imported at all."""

import importlib.util

from .target import PROJECT


def loaded(name):
    """A module of its own, of addon/NAME.py."""
    spec = importlib.util.spec_from_file_location(f"fovea_{name}", PROJECT / "addon" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
