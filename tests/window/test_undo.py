# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewport in a real window during many undo and redo steps."""


def test_fifty_operations_undone_and_done_again(play):
    found = play("many", words=[5, 50], timeout=240)
    assert found["undone"] == [] and found["redone"] == [], found
    assert found["changed"] >= 25 and len(set(found["names"])) >= 20, found
    assert found["calm"]
