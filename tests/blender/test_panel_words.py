# SPDX-License-Identifier: GPL-3.0-or-later
"""Labels, descriptions and limits in panels and operators follow Blender's conventions."""

import re

import bpy
import pytest
from panel_layouts import drawn_panels, full_scene, leaves, owners, shown_by
from the_addon import part


@pytest.fixture
def scene():
    return full_scene()


SMALL = {"a", "and", "as", "at", "by", "for", "from", "if", "in", "of", "on", "or", "out", "per", "the", "to", "with"}


def complaints(prop, title=None):
    """What is unlike Blender in the words of a property, or of an operator."""
    title, told = title or prop.name, prop.description
    words = re.findall(r"[A-Za-z][\w'-]*", re.sub(r"\(.*?\)", "", title))
    if any(word[0].islower() for word in words[1:] if word not in SMALL) or title[:1].islower():
        yield f"{title}: not in title case"
    if len(told.split()) < 3:
        yield f"{title}: no description"
    if told.endswith("."):
        yield f"{title}: the description ends with a full stop"
    items = [f"{item.name} {item.description}" for item in getattr(prop, "enum_items", ())]
    if re.search(r"olour|\bgrey|\w+metres\b|\bcentre", " ".join([title, told, *items]), re.I):
        yield f"{title}: Blender spells like Americans"


def test_words_are_as_blenders_own(scene):
    props = [prop for owner in owners(scene) for path, prop in leaves(owner) if not path.endswith(".name")]
    props.append(bpy.context.window_manager.bl_rna.properties["fovea_show_focus"])
    preferences = part("ui.preferences").FoveaPreferences.__annotations__
    entry = bpy.context.preferences.addons.get(part("ui.preferences").ADDON)
    props += [entry.preferences.bl_rna.properties[name] for name in preferences] if entry else []
    found = [word for prop in props for word in complaints(prop)]
    for name in dir(bpy.ops.fovea):
        kind = getattr(bpy.ops.fovea, name).get_rna_type()
        found += complaints(kind)
        shown = (prop for prop in kind.properties if not prop.is_hidden and prop.identifier != "rna_type")
        helpers = ("filepath", "check_existing", "filter_glob")
        found += [f"{name}: {word}" for prop in shown if prop.identifier not in helpers for word in complaints(prop)]
    assert not found, "\n".join(found)
    assert len(props) > 100 and len(dir(bpy.ops.fovea)) > 20


def test_numbers_are_dragged_over_what_makes_sense(scene):
    for owner in owners(scene):
        for path, prop in leaves(owner):
            if prop.type != "FLOAT" or prop.subtype in ("COLOR", "XYZ", "XYZ_LENGTH") or path.endswith("_index"):
                continue
            assert prop.hard_min > -1e9 and prop.soft_max <= 1000, path
            assert prop.default == 0 or prop.soft_max <= 1000 * prop.default, path


def test_titles_of_panels_are_as_blenders_own(scene):
    layout = shown_by()
    titles = {cls.bl_label for cls in drawn_panels()} | {text for text in layout.titles if len(text.split()) < 4}
    for title in titles:
        assert title[0].isupper() or title[0].isdigit(), title
