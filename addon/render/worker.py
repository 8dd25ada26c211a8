# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws beside the interface: one picture at a time, in a thread that touches nothing of Blender's.

Native calls let go of Python's lock, so Blender goes on meanwhile. Surfaces are shared between pictures, so whoever
changes one (reads a mesh that has changed) stops the drawing first.
"""

import threading
import time

_current = None  # the Job that runs, or ran last


class Job:
    """One picture on its way. `work(progress)` makes it, raising `cancelled` soon after `cancel.cancel()`."""

    def __init__(self, work, cancel, cancelled, *, draft):
        self.draft = draft  # to be shown though the view has moved on meanwhile
        self.result = self.error = None
        self.told = (0.0, "")  # share that is done, and what is being done
        self.started = time.monotonic()
        self._work, self._cancel, self._cancelled = work, cancel, cancelled
        self._done = threading.Event()
        self._thread = threading.Thread(target=self.run, name="Fovea viewport", daemon=True)

    def run(self):
        """Makes the picture, here and now."""
        try:
            self.result = self._work(self._progress)
        except self._cancelled:
            pass
        except Exception as error:  # told by whoever asked for the picture
            self.error = error
        finally:
            self._done.set()

    def _progress(self, share, text):
        self.told = (share, text)

    @property
    def done(self):
        return self._done.is_set()

    def wait(self, seconds):
        """Whether it is done within this time."""
        return self._done.wait(max(0.0, seconds))

    def start(self):
        self._thread.start()

    def stop(self):
        """Returns when it has stopped."""
        self._cancel.cancel()
        if self._thread.ident is not None:
            self._thread.join()


def start(job):
    """Starts a job, in place of one that still runs."""
    global _current
    stop()
    _current = job
    job.start()


def running():
    """The Job that runs, or None."""
    return _current if _current and not _current.done else None


def stop():
    """Stops what runs, and returns when it has stopped."""
    global _current
    if _current:
        _current.stop()
        _current = None
