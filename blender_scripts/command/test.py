# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs all tests on one target: native, native under sanitizers, Python without Blender, inside Blender, those that use
a GPU by Vulkan, too, in its window.
Native tests that take long with sanitizers, those of threads under the thread sanitizer, runs that are killed in a
loop, and Blender's tests with the self-contained module run only when named."""

import dataclasses
import os
import re
import shutil
import sys
import time
import xml.etree.ElementTree as xml
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from . import build, module_sources, package, sanitizers
from .target import PROJECT, YIELDING, StepFailed, say, tail

TESTS = PROJECT / "tests"
ABOUT_THREADS = "*Thread*:*Cache*:*Cancel*"  # native tests of parallel loops, caches and cancellation
PASSING = re.compile(r"\[ +(RUN|OK) +\]|\[-+\]|.* PASSED +\[|\s*$")  # lines of logs that are irrelevant to failures
WAY = re.compile(r' *File "/usr/lib|.*libpython|Extension modules|\s*$')  # Python's frames in crash reports


def test(target, words):
    """words: --without PART|none --jobs N [PART], then arguments for pytest. Counts go to WORK/results/counts."""
    parts, jobs, pytest_words = parse(words)
    results = target.work / "results"
    shutil.rmtree(results, ignore_errors=True)
    results.mkdir(parents=True)
    with ThreadPoolExecutor(jobs) as pool:
        running = [pool.submit(_part, target, part, results / f"{part}.xml", pytest_words) for part in parts]
        done = [task.result() for task in running]
    total = sum(done, Counter())
    (results / "counts").write_text(f"{total['passed']} {total['failed']} {total['skipped']}\n")
    say(f"{target.name}: logs and reports are in {target.work / 'log'}")
    return 1 if total["failed"] else 0


def parse(words):
    """The parts to run: the one that is named, else all but the long ones and the one that another target runs."""
    _, without, _, jobs, *rest = words
    part = rest.pop(0) if rest and rest[0] in PARTS else None
    return [part] if part else [name for name in PARTS if name not in (*LONG, without)], int(jobs), rest


def _part(target, part, report, words):
    """Runs one part and returns its counts; a failed build counts as one failure, so that other parts still run."""
    try:
        runs = PARTS[part](target, report, words)
    except StepFailed as failure:
        print(failure, flush=True)
        _remember(target, f"{target.name}: {failure}")
        counts = Counter(failed=1)
    else:
        with ThreadPoolExecutor(max(len(runs), 1)) as pool:
            counts = sum(pool.map(lambda run: outcome(target, part, *run), runs), Counter())
    told = ", ".join(f"{counts[kind]} {kind}" for kind in ("passed", "failed", "skipped"))
    say(f"{target.name}: {part} tests: {told}")
    return counts


def outcome(target, part, sentence, command, report, environment):
    """Runs a command of a part; returns its counts and prints failures."""
    start = time.time()
    log, status = target.attempt(sentence, command, **environment)
    counts = _counts(report) if report.exists() else Counter()
    ended = status != 0 and not counts["failed"] or not counts  # crashed, or found no tests
    counts["failed"] += ended
    if counts["failed"]:
        print(f"{target.name}: {part} tests FAILED; all of it is in {log}:\n{tail(log, 400, PASSING)}", flush=True)
        what = (
            f"ended with status {status}; its last lines:\n{tail(log, 30, WAY)}" if ended else _names_of_failed(report)
        )
        _remember(target, f"{target.name}: {sentence}: {what}{_crashes(target, start) if ended else ''}")
    return counts


def _remember(target, failure):
    """Records a failure, to be repeated after all parts have ended."""
    with (target.work / "results" / "failures").open("a") as file:
        file.write(f"{failure}\n")


# A part is a list of runs that may run concurrently: (name, command, report, environment).


def _native(target, report, _words):
    return _shards("native", build.build(target, "fovea_tests"), report)


def _sanitize(target, report, _words):
    return _sanitized(target, "sanitize", report, "-")


def _long_sanitize(target, report, _words):
    return _sanitized(target, "long_sanitize", report, "")


def _sanitized(target, part, report, sign):
    """sign: "-" leaves out the tests that take long with sanitizers, "" runs them alone."""
    folder = build.build(target, "fovea_tests", sanitize=True)
    shards = _shards(part, folder, report, f"--gtest_filter={sign}{':'.join(long_with_sanitizers())}")
    return [(sentence, [*YIELDING, *command], *rest) for sentence, command, *rest in shards]


def long_with_sanitizers():
    """Names of native tests, as GoogleTest has them."""
    lines = (TESTS / "native" / "long_with_sanitizers.txt").read_text(encoding="utf-8").splitlines()
    return [line for line in lines if not line.startswith("#")]


def _threads(target, report, _words):
    """One shard, because each of these tests uses all cores."""
    folder = build.preset(target, "thread-sanitize", "fovea_tests")
    return [_shard("threads", folder, report, 1, 1, f"--gtest_filter={ABOUT_THREADS}")]


def _shards(part, folder, report, *words):
    """GoogleTest shards, one per core, because most tests are single-threaded."""
    count = len(os.sched_getaffinity(0))
    return [_shard(part, folder, report.with_stem(f"{report.stem}-{i}"), i, count, *words) for i in range(1, count + 1)]


def _shard(part, folder, report, number, count, *words):
    environment = sanitizers.environment()
    environment |= {"GTEST_TOTAL_SHARDS": str(count), "GTEST_SHARD_INDEX": str(number - 1)}
    command = [folder / "fovea_tests", f"--gtest_output=xml:{report}", *words]
    return f"{part} tests {number} of {count}", command, report, environment


def _core(target, report, _words):
    """Tests of the tool, and of an installed core with a program that uses it; the native tests are a separate part."""
    folder = build.preset(target, "release", "fovea_core", "fovea_tool")
    command = ["ctest", "--test-dir", folder, "--exclude-regex", "native", "--output-on-failure"]
    return [("core tests", [*command, "--output-junit", report], report, {})]


def _python(target, report, words):
    package.stage(target)
    command = [sys.executable, "-m", "pytest", TESTS / "python", "-v", f"--junitxml={report}", *words]
    # Import the staged package, because the checkout's folder has no native module.
    path = str(package.importable(target))
    environment = {"PYTHONPATH": path, "PYTHONSAFEPATH": "1", "FOVEA_BLENDER": target.blender}
    environment["FOVEA_STANDALONE"] = str(target.cache / "standalone")
    return [("python tests", command, report, environment)]


def _blender(target, report, words):
    package.install(target)
    command = [target.blender, "-b", "--python-exit-code", "1", "-P", TESTS / "blender" / "run.py"]
    command += ["--", "-v", f"--junitxml={report}", *words]
    return [("blender tests", command, report, {"FOVEA_REPORTS": str(target.work / "log")})]


def _vulkan(target, report, words):
    """The tests that use a GPU, once more by Vulkan, which Mesa's drivers of the suites have without a GPU. Blender has
    it from 4.5 on; 4.3 crashes."""
    if not target.is_suite or _version(target) < (4, 5):
        say(f"{target.name}: no vulkan tests: they need a suite's Blender 4.5 or later")
        return []
    package.install(target)
    command = [target.blender, "-b", "--gpu-backend", "vulkan", "--python-exit-code", "1"]
    command += ["-P", TESTS / "blender" / "run.py", "--", "-v", f"--junitxml={report}", "-k", "gpu", *words]
    return [("vulkan tests", command, report, {"FOVEA_REPORTS": str(target.work / "log")})]


def _version(target):
    """(major, minor) of the target's Blender."""
    log = target.run("asking Blender for its version", [target.blender, "--version"])
    return tuple(map(int, re.search(r"^Blender (\d+)\.(\d+)", log.read_text(), re.MULTILINE).groups()))


def _window(target, report, words):
    package.install(target)
    command = [sys.executable, "-m", "pytest", TESTS / "window", "-v", f"--junitxml={report}", *words]
    environment = {"FOVEA_BLENDER": target.blender, "FOVEA_ZIP": str(package.package(target))}
    return [("window tests", command, report, environment)]


def _standalone(target, report, words):
    """Blender's tests with the self-contained module for its Python, installed in a home of its own."""
    name = f"linux-x64-cp{sys.version_info.major}{sys.version_info.minor}"
    found = sorted((target.cache / "standalone" / "modules" / name).glob("_native.*"))
    if not found or not module_sources.are_these(found[0]):
        raise StepFailed(f"no {name} of these sources is there: blender_scripts/fovea standalone {name} builds it")
    own = dataclasses.replace(target, work=target.work / "standalone", module=str(found[0]))
    own.home.mkdir(parents=True, exist_ok=True)
    ((_, command, _, environment),) = _blender(own, report, words)
    return [("blender tests with the self-contained module", command, report, environment | {"HOME": str(own.home)})]


def _kills(target, report, words):
    package.install(target)
    command = [sys.executable, "-m", "pytest", TESTS / "long", "-v", f"--junitxml={report}", *words]
    whole = [target.name, target.work, target.cache, target.blender, target.python_include, target.module]
    return [("runs that are killed", command, report, {"FOVEA_TARGET": "\n".join(map(str, whole))})]


def _crashes(target, start):
    """Blender's crash reports since `start`; frames in Blender are addresses, those of the native module have
    symbols."""
    files = [file for file in Path(os.environ["TMPDIR"]).glob("*.crash.txt") if file.stat().st_mtime >= start]
    return "".join(f"\n{file.name}:\n{tail(file, 40, WAY)}" for file in files)


def _counts(report):
    """Counts of passed, failed and skipped tests in a JUnit XML report by pytest or GoogleTest."""
    return Counter(_result(case) for case in xml.parse(report).iter("testcase"))


def _names_of_failed(report):
    failed = [case for case in xml.parse(report).iter("testcase") if _result(case) == "failed"]
    return "failed:\n" + "\n".join(f"    {case.get('classname')} {case.get('name')}" for case in failed[:40])


def _result(case):
    tags = {child.tag for child in case}
    if tags & {"failure", "error"}:
        return "failed"
    skipped = "skipped" in tags or case.get("result") == "skipped" or case.get("status") == "notrun"
    return "skipped" if skipped else "passed"


PARTS = {
    "native": _native,
    "python": _python,
    "blender": _blender,
    "vulkan": _vulkan,
    "window": _window,
    "core": _core,
    "sanitize": _sanitize,
    "long_sanitize": _long_sanitize,
    "threads": _threads,
    "kills": _kills,
    "standalone": _standalone,
}
# Parts that run only when named, because they take longer than all others.
LONG = ("long_sanitize", "threads", "kills", "standalone")
