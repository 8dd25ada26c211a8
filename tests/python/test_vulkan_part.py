# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea test` runs the tests that use a GPU once more by Vulkan, where Blender has it."""

from types import SimpleNamespace

import pytest
from command import test


@pytest.fixture
def runs(tmp_path, monkeypatch):
    """runs(version of Blender, words, is_suite): commands of the part."""
    monkeypatch.setattr(test.package, "install", lambda target: None)

    def commands(version, words=(), is_suite=True):
        log = tmp_path / "version.log"
        log.write_text(f"Blender {version} LTS\n    build date: none\n")
        target = SimpleNamespace(name="sid", blender="blender", work=tmp_path, is_suite=is_suite, run=lambda *_: log)
        return [list(map(str, run[1])) for run in test.PARTS["vulkan"](target, tmp_path / "report.xml", words)]

    return commands


@pytest.mark.parametrize("version", ["4.5.3", "5.0.0", "5.2.2", "10.0.1"])
def test_blender_is_asked_for_vulkan_and_for_all_tests_that_use_a_gpu(runs, version):
    (command,) = runs(version)
    assert command[command.index("--gpu-backend") + 1] == "vulkan"
    assert command[command.index("-k") + 1] == "gpu" and command.index("-k") > command.index("--")


def test_other_words_come_last_and_so_are_heeded(runs):
    (command,) = runs("5.2.2", ("-k", "spine"))
    assert command[-2:] == ["-k", "spine"]


def test_an_older_blender_and_one_of_the_users_own_are_left_alone(runs, capsys):
    assert runs("4.3.2") == [] and runs("5.2.2", is_suite=False) == []
    assert "they need a suite's Blender 4.5 or later" in capsys.readouterr().err


def test_the_part_is_among_those_that_run_by_default():
    assert "vulkan" in test.parse(["--without", "none", "--jobs", "1"])[0]


def test_a_part_without_anything_to_run_counts_nothing(monkeypatch, tmp_path):
    monkeypatch.setitem(test.PARTS, "vulkan", lambda *_: [])
    assert not test._part(SimpleNamespace(name="trixie"), "vulkan", tmp_path / "report.xml", [])
