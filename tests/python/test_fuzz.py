# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea fuzz` around its native program: what is left of inputs that end it."""

import sys
import time

import pytest
from command import fuzz

# Stands in for the program: refuses input 12, ends with an error at inputs 14 and 18, where it takes too long, and is
# done after input 20.
PROGRAM = """
import sys
_, kind, seed, step, seconds, state = sys.argv
for count, number in enumerate(range(int(seed), 21, int(step))):
    open(state, "w").write(f"{kind} {number} {count}          ")
    if number == 12:
        print(f"REFUSED: {kind} 12: Surface 1: it has no faces to refine", flush=True)
    if number == 14:
        print("ERROR: AddressSanitizer: heap-buffer-overflow", flush=True)
        sys.exit(1)
    if number == 18:
        print("HANGS: it takes too long", flush=True)
        sys.exit(3)
"""


@pytest.fixture
def worker(tmp_path):
    program = tmp_path / "program.py"
    program.write_text(PROGRAM)
    end = time.monotonic() + 600
    return fuzz.Worker("meshes", 10, 2, tmp_path / "meshes-0", end, [sys.executable, program], {})


def finish(worker):
    while worker.goes_on():
        time.sleep(0.01)


def test_an_input_that_fails_is_written_with_its_log_and_the_next_ones_are_tried(worker, tmp_path):
    finish(worker)
    assert worker.count == 6  # 10, 12, 14; 16, 18, 20
    assert (tmp_path / "failed-meshes-14.txt").read_text() == "meshes 14\n"
    assert "heap-buffer-overflow" in (tmp_path / "failed-meshes-14.log").read_text()
    assert [(each.file.name, each.is_slow) for each in worker.failures] == [
        ("failed-meshes-14.txt", False),
        ("failed-meshes-18.txt", True),
    ]
    assert "heap-buffer-overflow" in worker.failures[0].told


def test_what_takes_too_long_with_sanitizers_fails_only_where_it_does_without(worker):
    finish(worker)
    broken, slow = worker.failures
    assert fuzz.without_slow([broken, slow], lambda file: 3) == [broken, slow]
    assert fuzz.without_slow([broken, slow], lambda file: 0) == [broken], "others are not repeated"


def test_what_inputs_were_refused_with_is_kept(worker):
    finish(worker)
    assert worker.messages == {"Surface 1: it has no faces to refine"}


def test_no_process_begins_when_the_time_is_over(worker):
    worker.end = time.monotonic() - 1
    finish(worker)
    assert worker.count == 0 and not worker.failures


def test_every_core_has_a_worker_and_every_kind_at_least_one():
    for kinds in (["meshes"], ["styles"], ["meshes", "styles"]):
        shares = dict(fuzz.shares(kinds))
        assert list(shares) == kinds and min(shares.values()) >= 1
