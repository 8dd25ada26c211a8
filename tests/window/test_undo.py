# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewport in a real window during many undo and redo steps."""

from long_tests import IS_LONG

OPERATIONS = 50 if IS_LONG else 20


def test_many_operations_undone_and_done_again(play):
    found = play("many", words=[5, OPERATIONS], timeout=240)
    assert found["undone"] == [] and found["redone"] == [], found
    assert found["changed"] >= OPERATIONS / 2 and len(set(found["names"])) >= OPERATIONS * 2 / 5, found
    assert found["calm"]
