# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts inside Blender say of what ends them."""

import ending
import pytest


def ended(monkeypatch, main):
    monkeypatch.setattr("sys.argv", ["blender", "--", "word"])
    with pytest.raises(SystemExit) as said:
        ending.run(main)
    return said.value.code


@pytest.mark.parametrize(
    "error, sentence",
    [
        (ValueError("the sun is dark"), "fovea: the sun is dark"),
        (RuntimeError("Error: no such\nError: no such\nError: and more"), "fovea: no such; and more"),
        (PermissionError(13, "Permission denied", "artist.png"), "fovea: artist.png: Permission denied"),
        (OSError("the network is gone"), "fovea: the network is gone"),
    ],
)
def test_what_users_can_mend_is_a_sentence(monkeypatch, error, sentence):
    def main(_words):
        raise error

    assert ended(monkeypatch, main) == sentence


def test_too_little_memory_is_a_sentence(monkeypatch):
    def main(_words):
        raise MemoryError

    assert "memory is too small" in ended(monkeypatch, main)


def test_what_is_not_known_is_a_traceback(monkeypatch):
    def main(_words):
        raise KeyError("word")

    with pytest.raises(KeyError):
        monkeypatch.setattr("sys.argv", ["blender", "--"])
        ending.run(main)
