# SPDX-License-Identifier: GPL-3.0-or-later
"""hull, a vase and a bowl with an inverted hull: Solidify makes a second skin that is turned inside out, and whose
material shows no back faces, as characters of games have their outlines."""

from . import shapes, stage


def build(argument, shared):
    stage.clear()
    stage.frame()
    ink = stage.material("Ink", (0.01, 0.01, 0.012))
    ink.use_backface_culling = True
    profile = [
        (0, 0),
        (0.5, 0),
        (0.62, 0.25),
        (0.7, 0.7),
        (0.45, 1.15),
        (0.25, 1.4),
        (0.4, 1.65),
        (0.34, 1.65),
        (0.2, 1.4),
    ]
    vase = shapes.revolve("Vase", [*profile, (0.38, 1.1), (0.6, 0.7), (0.5, 0.2), (0, 0.1)], 64)
    bowl = shapes.revolve("Bowl", [(0, 0), (0.3, 0), (0.35, 0.08), (0.75, 0.5), (0.7, 0.5), (0.3, 0.14), (0, 0.12)], 64)
    for shape, color, at in ((vase, (0.2, 0.35, 0.6), (-0.7, 0, 0)), (bowl, (0.75, 0.4, 0.2), (0.8, -0.3, 0))):
        made = stage.link(shape.name, shape)
        made.location = at
        shape.materials.append(stage.material(shape.name, color))
        shape.materials.append(ink)
        skin = made.modifiers.new("Hull", "SOLIDIFY")
        skin.thickness, skin.offset, skin.use_flip_normals = 0.03, 1.0, True
        skin.material_offset = skin.material_offset_rim = 1
        skin.use_rim = False
    floor = shapes.sheet("Table", [[(-3, -2, 0), (-3, 2, 0)], [(3, -2, 0), (3, 2, 0)]])
    floor.materials.append(stage.material("Table", (0.7, 0.65, 0.55)))
    stage.link("Table", floor)
    stage.camera((1.5, -6.2, 3.0), (0, 0, 0.6))
    stage.sun(-60, 50)
