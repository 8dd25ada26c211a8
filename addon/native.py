"""Finds the native module, which lies beside this file, and says what is wrong when it cannot be used."""

import importlib
import sys
from pathlib import Path

UNSET = 0xFFFFFFFF  # an index that is none


class Unavailable(RuntimeError):
    """Why the native module cannot be used, in words for the user."""


def load():
    """The native module, the same object every time."""
    try:
        return importlib.import_module("._native", __package__)
    except ImportError as error:
        raise Unavailable(_explain(error)) from error


def _explain(error):
    here = Path(__file__).parent
    python = f"Python {sys.version_info.major}.{sys.version_info.minor}"
    found = sorted(path.name for pattern in ("_native*.so", "_native*.pyd") for path in here.glob(pattern))
    if not found:
        return "Fovea's native module is missing from the extension; build or install the extension again"
    if isinstance(error, ModuleNotFoundError):
        return f"Fovea has no native module for {python}, only {', '.join(found)}; install the build for this Blender"
    return f"Fovea's native module does not load in this Blender ({python}): {error}"
