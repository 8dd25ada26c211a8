# SPDX-License-Identifier: GPL-3.0-or-later
"""The messages of `fovea` when a script inside Blender fails: each sentence once, without Blender's own lines."""

import importlib
import sys

import ending
import pytest
from command import actions
from command.target import StepFailed

REPORTED = "Error: Camera 'A' looks in no direction\n"


class Blender:
    """A target whose Blender leaves this log and exit status."""

    blender = "blender"

    def __init__(self, folder, log, status):
        self.log, self.status = folder / "blender.log", status
        self.log.write_text(log)

    def attempt(self, sentence, command):
        return self.log, self.status


def test_files_that_were_written_are_told_and_no_others(tmp_path, capsys):
    odd = "/tmp/a \n\udc80\u2028b.png"
    ending.announce("/tmp/a_0001.png")
    ending.announce(odd)
    log = f"Saved: '/tmp/b.png'\n{capsys.readouterr().out}Blender quit\n"
    assert [path for path in map(ending.announced, log.splitlines()) if path] == ["/tmp/a_0001.png", odd]
    actions.in_blender(Blender(tmp_path, log.replace("\\udc80", ""), 0), "drawing A", "draw.py", [])
    assert capsys.readouterr().out == "/tmp/a_0001.png\n/tmp/a \n\u2028b.png\n"
    said(tmp_path, f"{log.splitlines()[1]}\nfovea: /tmp/a_0002.png could not be written\n")
    assert capsys.readouterr().out == "/tmp/a_0001.png\n"


@pytest.mark.parametrize("status", [0, 1])
def test_what_a_script_notes_is_said_once_beside_the_files(tmp_path, capsys, status):
    for _ in range(2):
        ending.note("Freestyle is on")
    ending.announce("/tmp/a.png")
    blender = Blender(tmp_path, capsys.readouterr().out, status)
    try:
        actions.in_blender(blender, "drawing A", "draw.py", [])
    except StepFailed as failure:
        assert status
        assert str(failure).startswith("drawing A FAILED")
    assert capsys.readouterr() == ("/tmp/a.png\n", "fovea: Freestyle is on\n")


def said(tmp_path, log, status=1):
    with pytest.raises(StepFailed) as failure:
        actions.in_blender(Blender(tmp_path, log, status), "drawing A", "draw.py", [])
    return str(failure.value)


def ended(error, monkeypatch):
    def main(words):
        raise error

    monkeypatch.setattr(sys, "argv", ["blender", "--", "A.blend"])
    with pytest.raises(SystemExit) as end:
        ending.run(main)
    return f"{end.value}\n"


def test_a_style_that_is_none_is_told_before_blender_starts(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(actions, "imported", lambda target, name: importlib.import_module(f"addon.{name}"))
    file, words = tmp_path / "a.json", ["boxes:1", "-o", str(tmp_path / "a.png"), "--style"]
    for text, reason in (("{", "the style is not JSON at line 1"), ("[" * 40, "nested more than 32 levels deep")):
        file.write_text(text)
        with pytest.raises(ValueError, match=f"--style {file}: .*{reason}"):
            actions.draw(None, [*words, str(file)])
    with pytest.raises(ValueError, match="there is no style 'none'"):
        actions.draw(None, [*words, "none"])
    file.write_text('{"schema": 1, "line_sets": [{}], "widht": 1}')
    actions.check_style(None, str(file))
    assert "does not know and leaves alone: widht" in capsys.readouterr().err


def test_what_blender_reports_and_raises_is_said_once(tmp_path, monkeypatch):
    last = ended(RuntimeError(REPORTED), monkeypatch)
    assert said(tmp_path, f"Read blend: A\n{REPORTED}{last}Blender quit\n") == "Camera 'A' looks in no direction"


def test_what_every_view_layer_reports_is_said_once(tmp_path, monkeypatch):
    assert said(tmp_path, ended(RuntimeError(2 * REPORTED), monkeypatch)) == "Camera 'A' looks in no direction"


def test_different_reports_are_all_said(tmp_path, monkeypatch):
    assert said(tmp_path, ended(RuntimeError("Error: one\nError: two\n"), monkeypatch)) == "one; two"


def test_too_little_memory_in_blender_is_said(tmp_path, monkeypatch):
    assert "memory is too small" in said(tmp_path, ended(MemoryError(), monkeypatch))


def test_what_only_a_programmer_can_mend_shows_the_end_of_the_log(tmp_path, monkeypatch):
    with pytest.raises(TypeError):
        ended(TypeError("enum not found"), monkeypatch)
    words = said(tmp_path, "Traceback\nTypeError: enum not found\nError: script failed\n")
    assert "drawing A FAILED (1)" in words and "TypeError: enum not found" in words


def test_a_blender_that_is_killed_is_told_from_one_that_ends(tmp_path):
    assert "FAILED (by signal 9, as when memory is too small)" in said(tmp_path, "", -9)
