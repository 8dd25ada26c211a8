# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of `fovea` that runs inside a suite or with the user's own Blender; blender_scripts/fovea starts it."""

import contextlib
import importlib
import signal
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import ending

from command import printed, temporary
from command.target import INTERRUPTS, StepFailed, Target, say

# Sub-commands with a module of their own; the others are functions of `actions`.
MODULES = ("check", "compare", "farm", "figures", "fit", "fuzz", "gaze", "learn", "lines", "study", "stub", "test")


def main(words):
    """words: NAME WORK CACHE BLENDER PYTHON_INCLUDE MODULE SUB-COMMAND ARGUMENTS..."""
    name, work, cache, blender, python_include, ready_module, subcommand, *rest = words
    for number in INTERRUPTS:
        signal.signal(number, interrupt)
    printed.watch()
    work = Path(work)
    try:
        with temporary.folder(work / "tmp") as held:
            target = Target(name, work, Path(cache), blender, python_include, held, ready_module)
            module = importlib.import_module(f"command.{subcommand if subcommand in MODULES else 'actions'}")
            status = getattr(module, subcommand)(target, rest)
            sys.stdout.flush()
            return status
    except StepFailed as failure:
        say(str(failure))
    except MemoryError:
        say(f"{subcommand}: memory is too small for this: take a simpler model, or a smaller --size")
    except printed.Unprinted as reason:
        say(f"{subcommand}: what it prints could not be written ({reason}): make room, or send it elsewhere")
    except OSError as error:
        say(f"{subcommand}: {ending.of_file(error)}")
    except ValueError as error:
        say(f"{subcommand}: {error}")
    except KeyboardInterrupt:
        return 130  # blender_scripts/fovea says so
    with contextlib.suppress(printed.Unprinted):  # the error is told already
        sys.stdout.flush()
    return 1


def interrupt(_number, _frame):
    """Ends what is done, once: what is interrupted again would not put its things in order."""
    for number in INTERRUPTS:
        signal.signal(number, signal.SIG_IGN)
    raise KeyboardInterrupt


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
