# SPDX-License-Identifier: GPL-3.0-or-later
"""What is built for Windows, and Wine, which runs it; `fovea test windows` builds it and says where all of it is."""

import os
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

PROJECT = Path(__file__).parents[2]
sys.path.insert(0, str(PROJECT / "blender_scripts"))

from command.standalone import wine  # noqa: E402


@pytest.fixture(scope="session")
def target():
    """The folders of `fovea standalone`: of this checkout's builds, and of the cache."""
    work, cache = os.environ["FOVEA_STANDALONE_WORK"], os.environ["FOVEA_STANDALONE"]
    return SimpleNamespace(work=Path(work), cache=Path(cache))


@pytest.fixture(scope="session")
def run(target):
    """run(program, words...): what a program of Windows, or else of this machine, prints; it returns 0."""

    def start(program, *words, status=0):
        command = [program, *words] if program.suffix != ".exe" else wine.command(program, *words)
        environment = os.environ | wine.environment(target)
        done = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, capture_output=True, check=False)
        said = done.stdout.decode().replace("\r\n", "\n")
        assert done.returncode == status, said[-1000:] + done.stderr.decode(errors="replace")[-1000:]
        return said

    return start
