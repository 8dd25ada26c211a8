# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scripts that `fovea` runs inside Blender tell it: each file that they have written, what else users should
know, each as one line, and, with exit status 1, errors that users can fix as one line; others with a traceback."""

import json
import sys

MARK = "fovea: "  # prefix of that line, which distinguishes it from Blender's own output
WROTE = "fovea wrote: "  # prefix of the line of a file, whose path follows as JSON
TOLD = "fovea tells: "  # prefix of the line of figures about a file, as JSON
NOTE = "fovea notes: "  # prefix of a line that is for the user


def note(sentence):
    """Tells the user something, whether or not there is an error."""
    print(f"{NOTE}{sentence}", flush=True)


def announce(path):
    """Tells of a file that is written."""
    print(f"{WROTE}{json.dumps(str(path))}", flush=True)


def tell(figures):
    """Tells figures about a file, a dict, in place of its path."""
    print(f"{TOLD}{json.dumps(figures)}", flush=True)


def told(line):
    """The JSON of figures in a line of output; None if it tells none."""
    return line.removeprefix(TOLD) if line.startswith(TOLD) else None


def announced(line):
    """The path in a line of output; None if it tells of no file."""
    return json.loads(line.removeprefix(WROTE)) if line.startswith(WROTE) else None


def run(main):
    """Calls main with the command line arguments after `--`."""
    try:
        main(sys.argv[sys.argv.index("--") + 1 :])
    except MemoryError:
        sys.exit(f"{MARK}memory is too small for this scene: simplify it, or lower --size")
    except OSError as error:
        sys.exit(MARK + of_file(error))
    except (ValueError, RuntimeError) as error:
        sys.exit(MARK + sentence(str(error)))


def of_file(error):
    """A sentence about an OSError."""
    return f"{error.filename}: {error.strerror}" if error.filename and error.strerror else str(error)


def sentence(text):
    """One line from the message of an operator's error, which has one report per line, repeated per view layer."""
    reports = (line.removeprefix("Error: ").strip() for line in text.splitlines())
    return "; ".join(dict.fromkeys(filter(None, reports)))
