"""The part of `fovea` that runs inside a suite, or beside an own Blender; blender_scripts/fovea starts it."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from command import actions
from command.target import StepFailed, Target, say


def main(words):
    """words: NAME WORK CACHE BLENDER PYTHON_INCLUDE SUB-COMMAND ARGUMENTS..."""
    target = Target(words[0], Path(words[1]), Path(words[2]), words[3], words[4])
    try:
        return getattr(actions, words[5])(target, words[6:])
    except StepFailed as failure:
        say(str(failure))
    except (ValueError, OSError) as error:
        say(f"{words[5]}: {error}")
    except KeyboardInterrupt:
        say("interrupted")
    return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
