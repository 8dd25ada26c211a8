# SPDX-License-Identifier: GPL-3.0-or-later
"""Every property of the add-on, in a real window."""


def test_every_property_changed_once_in_rendered(play):
    found = play("every_property", size=(480, 320), timeout=240)
    assert found["missing"] == []
    assert found["count"] > 150 and found["pictures"] > 100, found
    assert found["apart"] < 1e-5
    assert found["calm"]
