# SPDX-License-Identifier: GPL-3.0-or-later
"""Error handling of the scripts that `fovea` runs inside Blender: errors that the user can fix end with one line and
exit status 1, others with a traceback."""

import sys

MARK = "fovea: "  # prefix of that line, which distinguishes it from Blender's own output


def run(main):
    """Calls main with the command line arguments after `--`."""
    try:
        main(sys.argv[sys.argv.index("--") + 1 :])
    except MemoryError:
        sys.exit(f"{MARK}memory is too small for this scene: simplify it, or lower --size")
    except (ValueError, RuntimeError) as error:
        sys.exit(MARK + sentence(str(error)))


def sentence(text):
    """One line from the message of an operator's error, which has one report per line, repeated per view layer."""
    reports = (line.removeprefix("Error: ").strip() for line in text.splitlines())
    return "; ".join(dict.fromkeys(filter(None, reports)))
