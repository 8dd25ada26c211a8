# SPDX-License-Identifier: GPL-3.0-or-later
"""The page on the first drawing, followed exactly in a real window."""

import pytest


def test_the_page_leads_to_a_focus_pull_that_is_played_and_rendered(play):
    found = play("follow", size=(1280, 800), simulate=True)
    assert found["began"] == ["Camera", "Cube", "Light"], "what Blender starts with"
    assert found["place"] == pytest.approx([-3, 0, 0])
    assert found["pictures"] and min(found["changes"]) > 0.005, "each action is seen"
    assert found["range"] == [1, 48]
    assert len(found["played"]) > 2 and set(found["played"]) <= set(range(1, 49))
    assert found["led"] < 1e-4
    for place, others in found["contrast"].items():
        (elsewhere,) = (there for name, there in others.items() if name != place)
        assert others[place] > 1.15 * elsewhere, f"the {place} has more contrast where it is in focus"
