# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of `fovea` that runs inside a suite or with the user's own Blender; blender_scripts/fovea starts it."""

import importlib
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from command.target import StepFailed, Target, say

# Sub-commands with a module of their own; the others are functions of `actions`.
MODULES = ("check", "figures", "fuzz", "lines", "stub", "test")


def main(words):
    """words: NAME WORK CACHE BLENDER PYTHON_INCLUDE SUB-COMMAND ARGUMENTS..."""
    target = Target(words[0], Path(words[1]), Path(words[2]), words[3], words[4])
    try:
        module = importlib.import_module(f"command.{words[5] if words[5] in MODULES else 'actions'}")
        return getattr(module, words[5])(target, words[6:])
    except StepFailed as failure:
        say(str(failure))
    except (ValueError, OSError) as error:
        say(f"{words[5]}: {error}")
    except KeyboardInterrupt:
        say("interrupted")
    return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
