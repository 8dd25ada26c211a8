"""Every test on one target: native, native under sanitizers, Python without Blender, and inside Blender."""

import shutil
import sys
import xml.etree.ElementTree as xml
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from . import build, package
from .target import PROJECT, say, tail

TESTS = PROJECT / "tests"


@dataclass(frozen=True)
class Result:
    part: str
    log: Path
    counts: Counter  # of passed, failed, skipped


def test(target, words):
    """words: --sanitize yes|no --jobs N [PART], then words for pytest. Leaves the counts in WORK/results/counts."""
    parts, jobs, pytest_words = _parse(words)
    results = target.work / "results"
    shutil.rmtree(results, ignore_errors=True)
    results.mkdir(parents=True)
    _prepare(target, parts)
    with ThreadPoolExecutor(jobs) as pool:
        running = [pool.submit(PARTS[part], target, part, results / f"{part}.xml", pytest_words) for part in parts]
        done = [_reported(target, task.result()) for task in running]
    total = sum((result.counts for result in done), Counter())
    (results / "counts").write_text(f"{total['passed']} {total['failed']} {total['skipped']}\n")
    return 1 if total["failed"] else 0


def _parse(words):
    _, sanitize, _, jobs, *rest = words
    part = rest.pop(0) if rest and rest[0] in PARTS else None
    parts = [part] if part else [name for name in PARTS if name != "sanitize" or sanitize == "yes"]
    return parts, int(jobs), rest


def _prepare(target, parts):
    """What the parts share is built before they run side by side."""
    if "native" in parts:
        build.build(target, "fovea_tests")
    if "blender" in parts:
        package.install(target)
    elif "python" in parts:
        package.stage(target)


def _native(target, part, report, _words, **environment):
    folder = build.build(target, "fovea_tests", sanitize=part == "sanitize")
    command = [folder / "fovea_tests", f"--gtest_output=xml:{report}"]
    return _run(target, part, report, command, **environment)


def _sanitize(target, part, report, words):
    return _native(target, part, report, words, UBSAN_OPTIONS="print_stacktrace=1")


def _python(target, part, report, words):
    command = [sys.executable, "-m", "pytest", TESTS / "python", "-v", f"--junitxml={report}", *words]
    environment = {"PYTHONPATH": str(target.work / "package"), "FOVEA_BLENDER": target.blender}
    return _run(target, part, report, command, **environment)


def _blender(target, part, report, words):
    command = [target.blender, "-b", "--python-exit-code", "1", "-P", TESTS / "blender" / "run.py"]
    return _run(target, part, report, [*command, "--", "-v", f"--junitxml={report}", *words])


def _run(target, part, report, command, **environment):
    log, status = target.attempt(f"{part} tests", command, **environment)
    counts = _counts(report) if report.exists() else Counter()
    if status != 0 and not counts["failed"] or not counts:
        counts["failed"] += 1  # crashed, or found no tests
    return Result(part, log, counts)


def _counts(report):
    """Of a report by pytest or GoogleTest."""
    counts = Counter()
    for case in xml.parse(report).iter("testcase"):
        tags = {child.tag for child in case}
        skipped = "skipped" in tags or case.get("result") == "skipped" or case.get("status") == "notrun"
        counts["failed" if tags & {"failure", "error"} else "skipped" if skipped else "passed"] += 1
    return counts


def _reported(target, result):
    counts = result.counts
    if counts["failed"]:
        print(f"{target.name}: {result.part} tests FAILED; {result.log}:\n{tail(result.log, 400)}", flush=True)
    sentence = ", ".join(f"{counts[kind]} {kind}" for kind in ("passed", "failed", "skipped"))
    say(f"{target.name}: {result.part} tests: {sentence}")
    return result


PARTS = {"native": _native, "python": _python, "blender": _blender, "sanitize": _sanitize}
