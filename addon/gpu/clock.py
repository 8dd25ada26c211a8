# SPDX-License-Identifier: GPL-3.0-or-later
"""Times GPU passes for benchmarks by waiting for the GPU after each pass; inactive in normal drawing."""

import time


class Clock:
    """Sums the milliseconds of each pass in `stages`; None, the default, turns timing off."""

    stages = None

    def start(self):
        self._last = time.perf_counter()

    def mark(self, name, target=None):
        """Adds the time since the last mark or the start to stage `name`. `target`: the pass's Target, waited for."""
        if self.stages is None:
            return
        if target is not None:
            target.wait()
        now = time.perf_counter()
        self.stages[name] = self.stages.get(name, 0.0) + 1000 * (now - self._last)
        self._last = now
