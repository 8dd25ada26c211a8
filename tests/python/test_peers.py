# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea bench` reports the progress of Blender while it draws, and how it ended."""

import os
import sys

import pytest
from bench import peers


@pytest.fixture
def run(tmp_path, monkeypatch):
    """Runs Python code as a benchmark's Blender; returns the sentence about what went wrong."""
    monkeypatch.setattr(peers, "SIGN_OF_LIFE", 0.02)

    def started(code, timeout=60):
        return peers.run([sys.executable, "-c", code], dict(os.environ), timeout, tmp_path / "log")

    return started


def test_the_last_line_of_what_draws_is_shown_until_it_has_drawn(run, tmp_path, monkeypatch, capfd):
    shown, real = tmp_path / "shown", peers.last_lines

    def last_lines(*words):
        if found := real(*words):
            shown.touch()  # what draws ends
        return found

    monkeypatch.setattr(peers, "last_lines", last_lines)
    draw = (
        f"import os, time\nprint('first frame', flush=True)\nwhile not os.path.exists({str(shown)!r}): time.sleep(0.01)"
    )
    assert run(draw) is None
    told = capfd.readouterr().err.splitlines()
    assert told[-1].startswith("fovea:   ") and told[-1].endswith(" s: first frame")


def test_what_takes_too_long_is_stopped_and_said(run):
    assert run("import time; time.sleep(600)", timeout=0.1) == "stopped after 0 s"


@pytest.mark.parametrize(
    "code, said",
    [
        ("print('Error: no engine'); print('Blender quit'); raise SystemExit(3)", "ended with 3: Error: no engine"),
        ("print(1, 2, 3, 4, sep='\\n'); raise SystemExit(1)", "ended with 1: 2 3 4"),
        ("print('drawn')", None),
    ],
)
def test_how_it_ended_is_said(run, code, said):
    assert run(code) == said
