# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension installed and uninstalled as by a user, in a window."""

import os


def test_installed_from_its_zip_drawn_with_and_uninstalled_while_it_draws(play, tmp_path, monkeypatch):
    home = tmp_path / "home"
    home.mkdir()
    monkeypatch.setenv("HOME", str(home))
    found = play("coming_and_going", words=(os.environ["FOVEA_ZIP"],))
    assert found["before"] == {"engine": False, "modules": []}
    assert found["installed"]["engine"] and found["installed"]["ink"] > 1e-3
    assert found["after"] == {"engine": False, "files": [], "chosen": "BLENDER_WORKBENCH"}
