# SPDX-License-Identifier: GPL-3.0-or-later
"""The Visibility panel: settings that do not apply to a method are grayed out."""

from types import SimpleNamespace

import pytest
from the_addon import empty_scene, part

method = part("ui.method")
APPLIES = {  # method: the settings that make a difference
    "AUTO": {"probes", "depth_scale"},  # viewports on a GPU use the atlas
    "ATLAS": {"probes", "depth_scale"},
    "SPINE": {"probes", "depth_scale"},
    "ITEM_BUFFER": {"depth_scale", "layers"},
    "EXACT": set(),
}


class Layout:
    """Stands in for a panel's; its parts are grayed out with it."""

    def __init__(self, told, above=None):
        self.told, self.above, self.active, self.enabled = told, above, True, True

    def prop(self, _owner, name, **_options):
        self.told[name] = self.is_active()

    def is_active(self):
        return self.active and self.enabled and (self.above is None or self.above.is_active())

    def label(self, **_options):
        pass

    def row(self, **_options):
        return Layout(self.told, self)

    column = row


def test_every_method_is_told():
    assert set(APPLIES) == {item.identifier for item in empty_scene().fovea.bl_rna.properties["visibility"].enum_items}


@pytest.mark.parametrize("chosen", APPLIES)
def test_what_applies_to_a_method_is_active(chosen):
    scene, told = empty_scene(), {}
    scene.fovea.visibility = chosen
    panel = method.RENDER_PT_fovea_visibility
    panel.show(panel, Layout(told), SimpleNamespace(scene=scene, engine="FOVEA"))
    assert told.pop("visibility")
    assert set(told) == {"probes", "depth_scale", "layers"}
    assert {name for name, active in told.items() if active} == APPLIES[chosen]
