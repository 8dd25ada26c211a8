# SPDX-License-Identifier: GPL-3.0-or-later
"""Aliases for modules that moved from this package to others, so that existing scripts still import them."""

import importlib
import sys

MOVED = {
    "api": "render",
    "as_rendered": "render",
    "session": "render",
    "style_data": "style",
}  # module: its package now

for _name, _folder in MOVED.items():
    _module = importlib.import_module(f"..{_folder}.{_name}", __package__)
    globals()[_name] = sys.modules[f"{__name__}.{_name}"] = _module
