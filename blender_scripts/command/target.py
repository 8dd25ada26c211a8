# SPDX-License-Identifier: GPL-3.0-or-later
"""The target of a sub-command: one Blender, and this checkout's work folder for it in the cache."""

import contextlib
import fcntl
import itertools
import os
import re
import signal
import subprocess
import sys
import threading
import time
from dataclasses import dataclass
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
INTERRUPTS = (signal.SIGINT, signal.SIGTERM)
PATIENCE = 3  # seconds in which a process that is interrupted ends by itself
YIELDING = ["nice", "-n", "10"]  # begins a command that uses all cores, and leaves them to what runs beside it
LONGEST = 120  # bytes of a log's name; file systems take 255, encrypted ones 143
SHARED = PROJECT.parent / "shared"  # models that are not part of the project; may be absent

_logs = {}  # path -> open file, of each log of this process, which is locked as long as it runs


class StepFailed(RuntimeError):
    """A step failed; the message contains the end of its log."""


def say(sentence):
    print(f"fovea: {sentence}", file=sys.stderr, flush=True)


@dataclass(frozen=True)
class Target:
    name: str  # sid, trixie, or own-... for a Blender of the user's own
    work: Path  # build, package, home, logs and test results of this checkout
    cache: Path
    blender: str
    python_include: str  # folder of Python.h; "" if the interpreter reports it
    held: int | None = None  # descriptor of the lock on this run's temporary files (temporary.py)
    module: str = ""  # a self-contained module that the Blender loads; "": one is built

    @property
    def is_suite(self):
        return self.name in ("sid", "trixie")

    @property
    def home(self):
        return self.work / "home"

    def environment(self):
        """Environment of all processes. HOME is in the cache, so the user's Blender settings are neither read nor
        written."""
        kept = {
            name: value
            for name, value in os.environ.items()
            if not name.startswith("BLENDER_") and name not in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME")
        }
        # Paths relative to `work` let ccache share objects between clones.
        ccache = {"CCACHE_DIR": str(self.cache / "ccache"), "CCACHE_BASEDIR": str(self.work), "CCACHE_NOHASHDIR": "1"}
        ccache["CCACHE_SLOPPINESS"] = "pch_defines,time_macros"  # needed to cache files with precompiled headers
        ccache["CCACHE_DEPEND"] = "1"  # headers are those that the compiler names: else each file is read twice
        return kept | ccache | {"HOME": str(self.home), "PYTHONDONTWRITEBYTECODE": "1"}

    def run(self, sentence, command, **environment):
        """Runs a step with its output in a log and a progress message every 15 seconds; returns the log. StepFailed if
        it does not return 0."""
        log, status = self.attempt(sentence, command, **environment)
        if status != 0:
            raise StepFailed(f"{sentence} FAILED ({status}); the last lines of {log}:\n{tail(log, 25)}")
        return log

    def attempt(self, sentence, command, **environment):
        """As `run`, but returns (log, status) instead of raising."""
        say(f"{self.name}: {sentence}")
        log, output = _own_log(self.work / "log", sentence)
        start = time.monotonic()
        process = None
        try:
            with _interrupts_wait():
                process = subprocess.Popen(
                    [str(word) for word in command], stdin=subprocess.DEVNULL, stdout=output,
                    stderr=subprocess.STDOUT, env=self.environment() | environment,
                    pass_fds=() if self.held is None else (self.held,),
                )  # fmt: skip
            while True:
                with contextlib.suppress(subprocess.TimeoutExpired):
                    return log, process.wait(timeout=15)
                say(f"  {self.name}: {sentence} {time.monotonic() - start:.0f} s: {tail(log, 1).strip()[:80]}")
        finally:
            if process:
                _end(process)

    @contextlib.contextmanager
    def lock(self):
        """Context with an exclusive lock on this work folder, for builds and installations."""
        self.work.mkdir(parents=True, exist_ok=True)
        with (self.work / "lock").open("w") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            yield


def _own_log(folder, sentence):
    """(path, open file) of a log in a folder, emptied: the first of NAME.log, NAME-2.log, ... that no other run has. It
    stays when this run ends; the next one of the sentence takes it."""
    folder.mkdir(parents=True, exist_ok=True)
    name = re.sub(r"[^\w.,:-]", "-", sentence).encode()[:LONGEST].decode(errors="ignore")
    for number in itertools.count(1):
        log = folder / (f"{name}-{number}.log" if number > 1 else f"{name}.log")
        if log not in _logs:
            file = log.open("ab")
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                file.close()
                continue
            _logs[log] = file
        _logs[log].truncate(0)
        return log, _logs[log]


@contextlib.contextmanager
def _interrupts_wait():
    """Context that an interrupt ends at its end: a process that is being started is known by then."""
    told = []
    handlers = {}
    if threading.current_thread() is threading.main_thread():
        handlers = {number: signal.signal(number, lambda number, _frame: told.append(number)) for number in INTERRUPTS}
    try:
        yield
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
    for number in told:
        signal.raise_signal(number)


def _end(process):
    """Ends a process that still runs, as this one is interrupted: the terminal may have told it, too. Told twice,
    Blender leaves what it was writing."""
    for tell in (lambda: None, lambda: process.send_signal(signal.SIGINT), process.kill):
        tell()
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(timeout=PATIENCE)
            return


def tail(log, count, without=None):
    """The last lines of a log, indented; lines that match `without` are left out."""
    lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
    lines = [line for line in lines if not (without and without.match(line))]
    return "\n".join("    " + line for line in lines[-count:])
