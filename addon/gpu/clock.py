# SPDX-License-Identifier: GPL-3.0-or-later
"""What each pass costs, for benchmarks: the GPU is waited for after every pass, which drawing itself never does."""

import time


class Clock:
    """Set `stages` to {} to have the milliseconds of each pass added up there."""

    stages = None

    def start(self):
        self._last = time.perf_counter()

    def mark(self, name, target=None):
        """What happened since the last mark, or the start, was `name`; `target` is what it drew into."""
        if self.stages is None:
            return
        if target is not None:
            target.wait()
        now = time.perf_counter()
        self.stages[name] = self.stages.get(name, 0.0) + 1000 * (now - self._last)
        self._last = now
