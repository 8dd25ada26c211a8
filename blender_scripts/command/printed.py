# SPDX-License-Identifier: GPL-3.0-or-later
"""Standard output that may be lost, as on a full disk: told apart from other files, and told once."""

import io
import sys


class Unprinted(Exception):
    """What was printed could not be written; the message is the system's reason."""


class Output(io.FileIO):
    """Standard output as a file without a buffer. A failure raises Unprinted; what follows is dropped, because Python
    tries at its end once more to write what it holds."""

    lost = False

    def write(self, data):
        try:
            return len(data) if self.lost else super().write(data)
        except OSError as error:
            self.lost = True
            raise Unprinted(error.strerror) from error


def watch():
    """Makes failures of what is printed from now on raise Unprinted."""
    before = sys.stdout
    kept = {"encoding": before.encoding, "errors": before.errors, "line_buffering": before.line_buffering}
    sys.stdout = io.TextIOWrapper(io.BufferedWriter(Output(before.fileno(), "w", closefd=False)), **kept)
