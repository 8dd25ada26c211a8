# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs what is built for Windows by Wine: all native tests, and tests/windows, which compares it with what Linux
draws."""

import os
import shutil
import subprocess
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

from .. import test
from ..target import PROJECT, StepFailed, say
from . import build, toolchain, trial

WINDOWS, LINUX = toolchain.PLATFORMS["windows-x64"], toolchain.PLATFORMS["linux-x64"]
PART = "windows"


def run(target, words):
    """Builds the programs and runs them, and modules that are built; words: for pytest. Writes the counts to
    WORK/results/counts, as all parts of `fovea test`; 0 if all pass."""
    program()
    results = target.work / "results"
    shutil.rmtree(results, ignore_errors=True)
    results.mkdir(parents=True)
    build.program(target, LINUX, "fovea_tool")
    build.program(target, WINDOWS, "fovea_tool")
    tests = build.program(target, WINDOWS, "fovea_tests")
    variables = environment(target)
    # The first program in a new folder of Wine's makes it.
    target.run("setting up Wine", command("wineboot", "--init"), **variables)
    try:
        with ThreadPoolExecutor() as pool:
            shards = list(pool.map(lambda shard: test.outcome(target, PART, *shard), native(tests, results, variables)))
        counts = sum(shards, Counter()) + test.outcome(target, PART, *pictures(target, results, words))
    finally:
        subprocess.run(["wineserver", "-k"], env=os.environ | variables, check=False)
    told = ", ".join(f"{counts[kind]} {kind}" for kind in ("passed", "failed", "skipped"))
    say(f"{target.name}: {PART} tests: {told}")
    (results / "counts").write_text(f"{counts['passed']} {counts['failed']} {counts['skipped']}\n")
    return 1 if counts["failed"] else 0


def native(program, results, variables):
    """The native tests in as many processes as there are cores."""
    count = len(os.sched_getaffinity(0))
    for number in range(1, count + 1):
        report = results / f"native-{number}.xml"
        shard = variables | {"GTEST_TOTAL_SHARDS": str(count), "GTEST_SHARD_INDEX": str(number - 1)}
        words = command(program, f"--gtest_output=xml:Z:{report}")
        yield f"native tests in Wine {number} of {count}", words, report, shard


def pictures(target, results, words):
    """tests/windows."""
    report = results / "windows.xml"
    folder = PROJECT / "tests" / "windows"
    python = next(iter(trial.pythons().values()))
    words = [python, "-B", "-m", "pytest", "-v", "-p", "no:cacheprovider", folder, f"--junitxml={report}", *words]
    place = {"FOVEA_STANDALONE": str(target.cache), "FOVEA_STANDALONE_WORK": str(target.work)}
    return "what Windows' programs draw and load", words, report, place


def program():
    """Wine's program; StepFailed if there is none."""
    if not shutil.which("wine"):
        raise StepFailed(
            "wine is missing, which runs what is built for Windows: install it (apt-get install wine wine64)"
        )
    return "wine"


def command(name, *words):
    return [program(), str(name), *map(str, words)]


def environment(target):
    """A folder of its own for Wine's settings; no window, no Mono and no browser, and no messages of Wine's own."""
    quiet = {"WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml=", "DISPLAY": ""}
    return quiet | {"WINEPREFIX": str(target.work / "wine")}
