# SPDX-License-Identifier: GPL-3.0-or-later
"""The same picture, to the last bit, by every build of the module, and whichever instructions of the processor Embree,
the C library and NumPy use."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pictures
import pytest

PROCESSORS = {
    "Embree with SSE2": {"FOVEA_EMBREE": "max_isa=sse2"},
    "Embree with AVX": {"FOVEA_EMBREE": "max_isa=avx"},
    "a C library without FMA, AVX2 and AVX-512": {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F"},
    "one thread": {"FOVEA_EMBREE": "max_isa=sse4.2,threads=1"},
}


def drawn(scenes, environment):
    """{what: digest}, drawn in a process of its own."""
    path = [entry for entry in sys.path if entry]
    script = f"import sys; sys.path[:0] = {path!r}; import pictures\n"
    script += f"for what, digest in pictures.tell({str(scenes)!r}): print(what, digest, sep='|')"
    words = [sys.executable, "-c", script]
    done = subprocess.run(words, capture_output=True, text=True, env=os.environ | environment, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return dict(line.split("|") for line in done.stdout.splitlines())


@pytest.fixture(scope="module")
def here(tmp_path_factory):
    """(scenes' file, what this processor draws of them)."""
    scenes = Path(tmp_path_factory.mktemp("pictures")) / "scenes.npz"
    pictures.save(scenes)
    return scenes, drawn(scenes, {})


def test_every_build_draws_what_all_others_do(here):
    """digests.json is the same for all compilers, their libraries and both Embrees. What draws otherwise on purpose
    renews it: `python pictures.py IMPORTABLE`."""
    assert here[1] == json.loads((Path(__file__).parent / "digests.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("processor", PROCESSORS)
def test_a_picture_is_the_same_with(processor, here):
    scenes, expected = here
    assert len(set(expected.values())) > 10, "scenes that differ are drawn"
    assert drawn(scenes, PROCESSORS[processor]) == expected
