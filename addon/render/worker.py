# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws pictures in a background thread, one at a time, without access to Blender data.

Native calls release Python's global interpreter lock, so Blender stays responsive. Pictures share surfaces, so code
that modifies one (by reading a changed mesh) must stop the worker first.
"""

import threading
import time

NAME = "Fovea viewport"  # of the thread
_current = None  # the Job that is running, or ran last


class Job:
    """The drawing of one picture. `work(progress)` returns it, and raises `cancelled` soon after `cancel.cancel()`."""

    def __init__(self, work, cancel, cancelled, *, draft):
        self.draft = draft  # shown even if the view has changed meanwhile
        self.result = self.error = None
        self.told = (0.0, "")  # progress: share in [0, 1], stage
        self.started = time.monotonic()
        self._work, self._cancel, self._cancelled = work, cancel, cancelled
        self._done = threading.Event()
        self._thread = threading.Thread(target=self.run, name=NAME, daemon=True)

    def run(self):
        """Draws the picture in the calling thread."""
        try:
            self.result = self._work(self._progress)
        except self._cancelled:
            pass
        except Exception as error:  # raised again by the Viewport
            self.error = error
        finally:
            self._done.set()

    def _progress(self, share, text):
        self.told = (share, text)

    @property
    def done(self):
        return self._done.is_set()

    def wait(self, seconds):
        """Waits up to this many seconds; returns whether it is done."""
        return self._done.wait(max(0.0, seconds))

    def start(self):
        self._thread.start()

    def stop(self):
        """Cancels it and blocks until its thread has ended."""
        self._cancel.cancel()
        if self._thread.ident is not None:
            self._thread.join()


def start(job):
    """Starts a job after canceling the running one."""
    global _current
    stop()
    _current = job
    job.start()


def running():
    """The running Job, or None."""
    return _current if _current and not _current.done else None


def stop():
    """Cancels the running job and blocks until it has ended."""
    global _current
    if _current:
        _current.stop()
        _current = None
