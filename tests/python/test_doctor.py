# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea doctor` says what there is to draw with and what is missing, on machines with nothing, too, and sets up
nothing."""

import json
import os
import shutil
import subprocess
import sys

import pytest
from own_blenders import HERS, PROJECT, with_module

pytest_plugins = ("own_blenders",)

# What every system has, and no more: no Python, no compiler, no way to install anything.
TOOLS = "cat cut dirname grep head id mktemp paste readlink rm sed sha256sum tr".split()


@pytest.fixture
def doctor(tmp_path):
    """doctor(words, environment): its status, what it prints and what it says, as no root on a machine with nothing."""
    bare = tmp_path / "bare"
    bare.mkdir()
    for tool in TOOLS:
        (bare / tool).symlink_to(shutil.which(tool))
    (bare / "id").unlink()
    (bare / "id").write_text("#!/bin/sh\necho 1000\n")
    (bare / "id").chmod(0o755)

    def run(*words, path="", **environment):
        environment = {"PATH": f"{path}{bare}", "FOVEA_CACHE": str(tmp_path / "cache")} | environment
        done = subprocess.run(
            ["/bin/sh", PROJECT / "blender_scripts" / "fovea", "doctor", *words],
            env=environment, capture_output=True, text=True,
        )  # fmt: skip
        return done.returncode, done.stdout, done.stderr

    return run


def test_a_machine_with_nothing_is_told_both_ways_to_a_picture(doctor, tmp_path):
    status, told, said = doctor()
    assert status == 1 and said == "" and not (tmp_path / "cache").exists()
    assert told.count("not set up") == 2 and "none; 'blender_scripts/fovea standalone' makes" in told
    remedy = told.splitlines()[-1]
    assert "install Blender 4.2 or later" in remedy and "once as root" in remedy


def test_the_same_as_json(doctor):
    status, told, _ = doctor("--json")
    found = json.loads(told)
    assert status == 1 and found["draw"]["uses"] is None and "as root" in found["draw"]["remedy"]
    assert [each["where"] for each in found["blenders"]] == ["sid", "trixie"] and found["modules"] == []
    assert found["gpu"] == {"possible": False, "hardware": False, "renderer": None}


@with_module
def test_a_blender_with_the_module_that_fits_is_told_with_its_python(doctor, blender, fitting, tmp_path):
    before = sorted((tmp_path / "cache").rglob("*"))
    status, told, said = doctor(BLENDER=str(blender()))
    python = f"{sys.version_info.major}.{sys.version_info.minor}"
    assert status == 0 and said == ""
    assert f"BLENDER=  {blender()}: Blender 4.2.1, Python {python}, takes the self-contained module {HERS}/_nat" in told
    assert f"{HERS}: for Python {python}; taken by a Blender above" in told
    assert told.splitlines()[-1] == f"fovea draw uses {blender()}"
    assert sorted((tmp_path / "cache").rglob("*")) == before


@with_module
def test_of_two_blenders_that_of_the_variable_is_used(doctor, blender, fitting, tmp_path):
    other = tmp_path / "other blender"
    other.write_text(blender().read_text().replace("4.2.1", "5.1.0"))
    other.chmod(0o755)
    found = json.loads(doctor("--json", BLENDER=str(other), path=f"{blender().parent}:")[1])
    assert [(each["where"], each["version"], each["fits"]) for each in found["blenders"][:2]] == [
        ("BLENDER=", "5.1.0", True), ("PATH", "4.2.1", True)
    ]  # fmt: skip
    assert found["draw"]["uses"] == "BLENDER=" and found["modules"][0]["taken"] is True


def test_a_blender_without_module_is_told_with_what_is_missing(doctor, blender, modules):
    status, told, _ = doctor(BLENDER=str(blender()))
    sentence = next(line for line in told.splitlines() if "BLENDER=" in line)
    assert status == 1 and "there is no self-contained module" in sentence and "a C++20 compiler (g++)" in sentence
    assert "install what is missing" in told.splitlines()[-1]


def test_an_old_blender_on_path_is_told_and_not_used(doctor, blender):
    status, told, _ = doctor(path=f"{blender('3.4.1').parent}:")
    assert status == 1 and "is Blender 3.4.1, and Fovea needs Blender 4.2 or later" in told


def test_a_suite_that_is_set_up_is_told_with_versions_and_used(doctor, tmp_path):
    root = tmp_path / "cache/sid/root"
    for folder in ("usr/bin", "var/lib/dpkg"):
        (root / folder).mkdir(parents=True)
    (root / "usr/bin/blender").touch(0o755)
    (root / "usr/bin/python3").symlink_to("python3.14")
    others = "Package: blend\nVersion: 1\n\n", "\nPackage: c\nVersion: 2\n"
    own = "Package: blender\nStatus: ok\nVersion: 1:5.2.2+dfsg-1\n"
    (root / "var/lib/dpkg/status").write_text(own.join(others))
    status, told, _ = doctor()
    assert status == 0 and "sid       Blender 5.2.2, Python 3.14, Debian sid, set up; its module is built when" in told
    assert told.splitlines()[-1] == "fovea draw uses Debian sid"


@pytest.mark.parametrize("words, told", [(["--xml"], "takes --json"), (["--on", "sid"], "takes no --on")])
def test_other_words_are_refused(doctor, words, told):
    status, _, said = doctor(*words)
    assert status in (1, 2) and told in said and said.count("\n") == 1


@with_module
@pytest.mark.skipif("FOVEA_BLENDER" not in os.environ, reason="FOVEA_BLENDER names no Blender")
def test_a_whole_blender_answers_with_opengl_of_its_python(doctor, fitting):
    found = json.loads(doctor("--json", path="/usr/bin:", BLENDER=os.environ["FOVEA_BLENDER"])[1])
    assert found["draw"]["uses"] == "BLENDER=" and found["blenders"][0]["module"] == str(fitting)
    assert found["gpu"]["possible"] is (found["gpu"]["renderer"] is not None)
