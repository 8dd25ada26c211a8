"""Scenarios in a Blender with a window, on a screen of their own: `play` runs one and gives what it found."""

import json
import os
import random
import re
import shutil
import signal
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

HERE = Path(__file__).parent
SCREEN = "960x600"
COMPLAINTS = re.compile(r"Traceback|^\s*\w*(Error|Exception)\b|: error:|failed|SIGSEGV|Segmentation", re.M)
# What this Blender says without us: software OpenGL, no sound, and another add-on's network.
HARMLESS = re.compile(r"EGL_|AL lib|libGL|ALSA|pulse|jack|XDG_RUNTIME", re.I)


@dataclass
class Played:
    result: object  # what the scenario returned
    console: str  # what Blender said
    folder: Path  # where the scenario left its files

    def complaints(self):
        """Lines of the console that tell of trouble."""
        return [line for line in self.console.splitlines() if COMPLAINTS.search(line) and not HARMLESS.search(line)]


@pytest.fixture
def play(tmp_path):
    if not shutil.which("xvfb-run"):
        pytest.skip("there is no xvfb-run here to make a screen")

    def run(scenario, *words, simulate=False, timeout=150):
        """`simulate`: the scenario makes events of its own; Blender does not sleep then."""
        out = tmp_path / "out.json"
        geometry = ["--window-geometry", "0", "0", *SCREEN.split("x")]
        blender = [os.environ["FOVEA_BLENDER"], *(["--enable-event-simulate"] if simulate else []), *geometry]
        inside = ["-P", str(HERE / "inside.py"), "--", str(HERE / "scenarios.py"), scenario, str(out), *words]
        # Tests of two suites run side by side, each blind to the other's processes.
        number = str(random.SystemRandom().randrange(1000, 30000))
        screen = ["xvfb-run", "-a", "-n", number, "-s", f"-screen 0 {SCREEN}x24 -fbdir {tmp_path}"]
        environment = os.environ | {"FOVEA_SCREEN": str(tmp_path), "FOVEA_SECONDS": str(timeout)}
        console = _console(screen + blender + inside, environment, timeout + 10)
        assert out.exists(), f"Blender ended early:\n{console}"
        told = json.loads(out.read_text())
        assert "error" not in told, f"{told.get('error')}\n{console}"
        return Played(told["result"], console, tmp_path)

    return run


def _console(command, environment, timeout):
    """What a command says; it and all it started are ended after a while."""
    told = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True, "errors": "replace"}
    with subprocess.Popen(command, env=environment, start_new_session=True, stdin=subprocess.DEVNULL, **told) as child:
        try:
            return child.communicate(timeout=timeout)[0]
        except subprocess.TimeoutExpired:
            os.killpg(child.pid, signal.SIGKILL)
            return child.communicate()[0] + f"\nstopped after {timeout} s"
