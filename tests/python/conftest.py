"""Makes `addon` importable: the staged package with the native module (`fovea test` names it), else the checkout's."""

import importlib.util
import sys
from pathlib import Path

if importlib.util.find_spec("addon") is None:
    sys.path.insert(0, str(Path(__file__).parents[2]))
