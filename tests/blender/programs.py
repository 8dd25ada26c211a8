# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs that read files of drawings."""

import shutil
import subprocess

import pytest


def program(name):
    """Its path; where it is not installed, the test is skipped."""
    return shutil.which(name) or pytest.skip(f"there is no {name} here")


def ran(*words):
    """What a program prints that succeeds."""
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=100)
    assert done.returncode == 0, done.stderr
    return done.stdout
