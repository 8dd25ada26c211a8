# SPDX-License-Identifier: GPL-3.0-or-later
"""The worker draws one picture at a time in the background."""

import threading
import time

import pytest

from addon.render import worker


class Stopped(Exception):
    pass


class Cancel:
    def __init__(self):
        self.asked = threading.Event()

    def cancel(self):
        self.asked.set()


def job(work, *, draft=False):
    cancel = Cancel()
    return worker.Job(lambda tell: work(tell, cancel.asked), cancel, Stopped, draft=draft)


def forever(tell, asked):
    tell(0.5, "half")
    asked.wait(30)
    raise Stopped


@pytest.fixture(autouse=True)
def nothing_stays():
    yield
    worker.stop()
    assert not [thread for thread in threading.enumerate() if thread.name.startswith("Fovea")]


def test_a_job_gives_its_result():
    one = job(lambda tell, asked: 7)
    worker.start(one)
    assert one.wait(10) and one.done and one.result == 7 and one.error is None
    assert worker.running() is None


def test_what_goes_wrong_is_kept_for_whoever_asked():
    one = job(lambda tell, asked: 1 // 0)
    worker.start(one)
    assert one.wait(10) and isinstance(one.error, ZeroDivisionError) and one.result is None


def test_a_new_job_takes_the_place_of_the_old():
    old, new = job(forever), job(lambda tell, asked: "new")
    worker.start(old)
    assert not old.wait(0.05) and worker.running() is old and old.told == (0.5, "half")
    worker.start(new)
    assert old.done and old.result is None and old.error is None
    assert new.wait(10) and new.result == "new"


def test_stopping_waits_until_nothing_runs():
    def slow_to_stop(tell, asked):
        asked.wait(30)
        time.sleep(0.1)
        raise Stopped

    one = job(slow_to_stop)
    worker.start(one)
    worker.stop()
    assert one.done and worker.running() is None
    worker.stop()


def test_a_job_can_be_done_here_and_now():
    one = job(lambda tell, asked: threading.current_thread())
    one.run()
    assert one.done and one.result is threading.current_thread()
    one.stop()
