# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs Blender in a window on a virtual screen: `play` runs a scenario there (inside.py) and returns its result."""

import json
import os
import random
import signal
import subprocess
from dataclasses import dataclass
from pathlib import Path

INSIDE = Path(__file__).with_name("inside.py")


class Failed(RuntimeError):
    """A scenario did not finish; the message contains its traceback and Blender's output."""


@dataclass(frozen=True)
class Played:
    result: object  # what the scenario returned
    console: str  # Blender's output
    folder: Path  # folder of the scenario's files


def play(blender, environment, file, scenario, folder, words=(), *, size=(960, 540), simulate=False, timeout=150):
    """Runs a scenario (a generator function in a Python file, called with the folder and the words) in a window that
    fills a screen of `size` pixels. `simulate`: lets it simulate events; Blender then never sleeps. `timeout`: seconds.
    Needs xvfb-run. Failed on an error."""
    out, (width, height) = folder / "out.json", map(str, size)
    # Concurrent tests in different process namespaces do not see each other's displays, so the number is random.
    number = str(random.SystemRandom().randrange(1000, 30000))
    command = ["xvfb-run", "-a", "-n", number, "-s", f"-screen 0 {width}x{height}x24 -fbdir {folder}", str(blender)]
    command += ["--enable-event-simulate"] if simulate else []
    command += ["--window-geometry", "0", "0", width, height, "-P", str(INSIDE), "--", str(file), scenario, str(out)]
    more = {"FOVEA_SCREEN": str(folder), "FOVEA_SECONDS": str(timeout)}
    console = _console([*command, *map(str, words)], environment | more, timeout + 10)
    told = json.loads(out.read_text()) if out.exists() else {"error": "Blender ended early"}
    if "error" in told:
        raise Failed(f"{told['error']}\n{console}")
    return Played(told["result"], console, folder)


def _console(command, environment, timeout):
    """Runs a command and returns its output; kills its process group after `timeout` seconds."""
    told = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True, "errors": "replace"}
    with subprocess.Popen(command, env=environment, start_new_session=True, stdin=subprocess.DEVNULL, **told) as child:
        try:
            return child.communicate(timeout=timeout)[0]
        except subprocess.TimeoutExpired:
            os.killpg(child.pid, signal.SIGKILL)
            return child.communicate()[0] + f"\nstopped after {timeout} s"
