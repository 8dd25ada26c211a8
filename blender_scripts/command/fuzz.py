# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea fuzz`: random inputs for the core, under sanitizers (tests/native/fuzz)."""

import argparse
import os
import re
import shutil
import subprocess
import time
from pathlib import Path
from typing import NamedTuple

from . import build, sanitizers
from .target import say, tail

KINDS = ("meshes", "styles")
VARIES = re.compile(r"'[^']*'|[-+]?\d[\d.e+-]*|\b-?(nan|inf)\b")  # in messages that are alike
TOO_LONG = "HANGS: it takes too long"  # what the program says as it ends such an input
BOUNDS = {"ASAN_OPTIONS": "handle_abort=1:hard_rss_limit_mb=3000:max_allocation_size_mb=2000"}


def parse(words):
    parser = argparse.ArgumentParser("fovea fuzz")
    parser.add_argument("file", nargs="?", type=Path, help="inputs to repeat, a line for each: 'meshes 17'")
    parser.add_argument("--tell", action="store_true", help="what the inputs of a file consist of, instead")
    parser.add_argument("--minutes", type=float, default=2.0, help="how long (2)")
    parser.add_argument("--seed", type=int, help="of the first input; by default another one each time")
    parser.add_argument("--only", choices=KINDS)
    parser.add_argument("--release", action="store_true", help="without sanitizers: several times as many inputs")
    parser.add_argument("--list-messages", action="store_true", help="what inputs were refused with, a line for each")
    return parser.parse_args(words)


def fuzz(target, words):
    options = parse(words)
    if not target.is_suite:
        raise ValueError("it needs the compiler and libraries of a Debian suite: --on sid or --on trixie")
    program = build.build(target, "fovea_fuzz", sanitize=not options.release) / "fovea_fuzz"
    environment = target.environment() | sanitizers.environment() | BOUNDS
    if options.file:
        verb = "tell" if options.tell else "repeat"
        return subprocess.run([program, verb, options.file.absolute()], env=environment, check=False).returncode
    first = int(time.time()) * 1_000_000 if options.seed is None else options.seed
    folder = target.work / "log" / "fuzz"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    say(f"{target.name}: fuzz for {options.minutes:g} minutes, seeds from {first}; logs are in {folder}")
    end = time.monotonic() + 60.0 * options.minutes
    kinds = [options.only] if options.only else KINDS
    workers = [
        Worker(kind, first + number, step, folder / f"{kind}-{number}", end, [program, "run"], environment)
        for kind, step in shares(kinds)
        for number in range(step)
    ]
    while sum(worker.goes_on() for worker in workers):
        time.sleep(0.2)
    if options.list_messages:
        of_kind = {VARIES.sub("", message): message for worker in workers for message in worker.messages}
        print("\n".join(sorted(of_kind.values())))
    failures = [failure for worker in workers for failure in worker.failures]
    if any(failure.is_slow for failure in failures) and not options.release:
        release = build.build(target, "fovea_fuzz") / "fovea_fuzz"
        failures = without_slow(
            failures, lambda file: subprocess.run([release, "repeat", file], check=False).returncode
        )
    for failure in failures:
        print(f"{failure.file} FAILED:\n{failure.told}")
    drawn = ", ".join(f"{sum(each.count for each in workers if each.kind == kind)} {kind}" for kind in kinds)
    say(f"{target.name}: {drawn}: {len(failures)} failed")
    return 1 if failures else 0


def shares(kinds):
    """(kind, number of workers), one for each core; a tenth of all inputs, about, are not of the first kind."""
    cores = len(os.sched_getaffinity(0))
    return [(kind, max(1, cores - len(kinds) + 1) if kind == kinds[0] else 1) for kind in kinds]


class Failure(NamedTuple):
    file: Path  # of its input
    told: str  # the end of its log
    is_slow: bool  # it took too long


def without_slow(failures, repeat):
    """The failures but those that took too long with sanitizers, as these cost more than the limit allows for, and end
    in time without them. `repeat`: from the file of an input to an exit status."""
    return [failure for failure in failures if not failure.is_slow or repeat(failure.file) != 0]


class Worker:
    """A process that runs inputs of a kind, and another one from the next input on where one has ended it."""

    def __init__(self, kind, seed, step, files, end, command, environment):
        self.kind, self.seed, self.step, self.files, self.end = kind, seed, step, files, end
        self.command, self.environment = command, environment
        self.count, self.messages, self.failures = 0, set(), []
        self.process = None

    def goes_on(self):
        """Starts the process, or the next one; whether there is one."""
        if self.process and self.process.poll() is None:
            return True
        if self.process:
            self._read()
        if self.process and self.process.returncode == 0 or time.monotonic() > self.end:
            self.process = None
            return False
        words = [self.kind, self.seed, self.step, self.end - time.monotonic(), self._file("state")]
        with self._file("log").open("wb") as log:
            self.process = subprocess.Popen(
                [str(word) for word in [*self.command, *words]], stdout=log, stderr=log, env=self.environment
            )
        return True

    def _read(self):
        """What the process that has ended leaves."""
        _, seed, count = self._file("state").read_text().split()
        self.count += int(count) + 1
        for line in self._file("log").read_text(errors="replace").splitlines():
            if line.startswith("REFUSED: "):
                self.messages.add(line.split(": ", 2)[2])
        if self.process.returncode != 0:
            failed = self.files.with_name(f"failed-{self.kind}-{seed}")
            failed.with_suffix(".txt").write_text(f"{self.kind} {seed}\n")
            self._file("log").rename(failed.with_suffix(".log"))
            log = failed.with_suffix(".log")
            is_slow = TOO_LONG in log.read_text(errors="replace")
            self.failures.append(Failure(failed.with_suffix(".txt"), tail(log, 30), is_slow))
        self.seed = int(seed) + self.step

    def _file(self, suffix):
        return self.files.with_suffix(f".{suffix}")
