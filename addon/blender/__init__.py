# SPDX-License-Identifier: GPL-3.0-or-later
"""Modules for scripts by the names that they had before they moved to folders of their subjects."""

import importlib
import sys

MOVED = {"api": "scene", "as_rendered": "render", "session": "render", "style_data": "style"}  # module: its folder

for _name, _folder in MOVED.items():
    _module = importlib.import_module(f"..{_folder}.{_name}", __package__)
    globals()[_name] = sys.modules[f"{__name__}.{_name}"] = _module
