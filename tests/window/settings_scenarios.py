# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios that change every property of the add-on in Rendered shading. Tests check what a scenario returns."""

import bpy
import numpy as np
from showing import calm, opened
from the_addon import add_hidden, only_lines, part, use_style
from window import screen

catalogue = part("catalogue")
MOST_ITEMS = 3  # of an enum that are tried: most textures differ in nothing but their pixels
ON = ("contour", "crease")  # kinds of lines that are drawn all the time; others with each of their parameters


def owners():
    """What has properties of the add-on: names and the groups."""
    scene = bpy.context.scene
    obj = scene.objects["Boxes"]
    return {
        "scene": scene.fovea,
        "viewport": scene.fovea_viewport,
        "object": obj.fovea,
        "material": obj.data.materials[0].fovea,
        "style": scene.fovea.style.fovea,
    }


def leaves(group, path):
    """(path, group, property) of all numbers, words, switches and pointers to datablocks in a group."""
    for prop in group.bl_rna.properties:
        name = prop.identifier
        if name == "rna_type" or prop.is_hidden or prop.is_readonly and prop.type not in ("POINTER", "COLLECTION"):
            continue
        value, here = getattr(group, name), f"{path}.{name}"
        if prop.type == "COLLECTION":
            for i, element in enumerate(value):
                yield from leaves(element, f"{here}[{i}]")
        elif isinstance(value, bpy.types.PropertyGroup):
            yield from leaves(value, here)
        else:
            yield here, group, prop


def others(group, prop):
    """Values far from the one that a property has."""
    now = getattr(group, prop.identifier)
    if prop.type == "BOOLEAN":
        return [not now]
    if prop.type == "ENUM":
        return [item.identifier for item in prop.enum_items if item.identifier != now][:MOST_ITEMS]
    if prop.type == "STRING":
        return ["word"]
    if prop.type == "POINTER":
        return [found for found in datablocks(prop.fixed_type.identifier) if found != now][:1]
    if prop.array_length:
        return [(prop.soft_max if now[0] != prop.soft_max else prop.soft_min,) * prop.array_length]
    return [prop.soft_max if prop.soft_max - now > now - prop.soft_min else prop.soft_min]


def datablocks(kind):
    known = {"NodeTree": "node_groups", "Object": "objects", "Image": "images"}
    known |= {"Collection": "collections", "Material": "materials"}
    return list(getattr(bpy.data, known[kind]))


def kind_of(prop):
    """The kind of lines whose parameter a property is, or None."""
    owners = {f"{d['name']}_{p['name']}": d["name"] for d in catalogue.definitions() for p in d["parameters"]}
    return owners.get(prop.identifier)


def kept(value):
    return tuple(value) if hasattr(value, "__len__") and not isinstance(value, str) else value


def every_property(folder):
    """Each is set to what is far from its value, and back when that is seen: how many there were, those after which no
    picture came, and how far the picture is in the end from that of the beginning."""
    watch = yield from opened("boxes:2")
    scene = bpy.context.scene
    bpy.data.images.new("Density", 8, 8)
    part("style.style_data").new("Other", part("style").load("pencil"))
    held = use_style(scene, "xray_focus")
    while len(held.line_sets) > 1:
        held.line_sets.remove(0)
    only_lines(scene, *ON)
    held.line_sets[0].hidden.clear()
    add_hidden(held.line_sets[0])
    held.line_sets[0].away = held.line_sets[0].hidden[0].away = True
    scene.fovea.focus_model = "SCENE"
    scene.fovea.focus_points.add()
    yield from watch.refined()
    start, told, missing, seen = screen.picture()[16:], 0, [], set()
    for owner, group in owners().items():
        for path, place, prop in leaves(group, owner):
            before = kept(getattr(place, prop.identifier))
            kind = kind_of(prop)
            for value in others(place, prop):
                if kind:
                    setattr(place, kind, True)
                setattr(place, prop.identifier, value)
                screen.swap()
                try:
                    yield from screen.until(lambda: shows(watch), seconds=15)
                except TimeoutError:
                    missing.append(f"{path} = {value!r}")
                seen.add(watch.of(screen.area()).wanted.key if watch.of(screen.area()).wanted else None)
            setattr(place, prop.identifier, before)
            if kind:
                setattr(place, kind, kind in ON)
            told += 1
    yield from watch.refined()
    apart = float(np.abs(screen.picture()[16:] - start).mean())
    return {"count": told, "missing": missing, "pictures": len(seen), "apart": apart, "calm": (yield from calm())}


def shows(watch):
    """Whether the viewport shows what it is to show, be it coarsely."""
    one = watch.of(screen.area())
    return one.shown is not None and one.wanted is not None and one.shown.wanted.key == one.wanted.key
