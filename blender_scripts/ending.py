# SPDX-License-Identifier: GPL-3.0-or-later
"""How the scripts that `fovea` runs inside Blender end: where the user can mend what is wrong, with a line that says so
and exit status 1; else with a traceback."""

import sys

MARK = "fovea: "  # begins that line, to be told from what Blender reports beside it


def run(main):
    """Calls main with the words after `--`."""
    try:
        main(sys.argv[sys.argv.index("--") + 1 :])
    except MemoryError:
        sys.exit(f"{MARK}memory is too small for this scene: simplify it, or lower --size")
    except (ValueError, RuntimeError) as error:
        sys.exit(MARK + sentence(str(error)))


def sentence(text):
    """One line of what Blender's operators raise: each of their reports in a line of its own, perhaps repeated, as every
    view layer says what is wrong."""
    reports = (line.removeprefix("Error: ").strip() for line in text.splitlines())
    return "; ".join(dict.fromkeys(filter(None, reports)))
