# SPDX-License-Identifier: GPL-3.0-or-later
"""A stand-in for Blender's layouts that records what panels draw, and a scene in which panels show all their
properties."""

from types import SimpleNamespace

import bpy
from the_addon import add_hidden, empty_scene, fovea, lines_of, only_lines, own_style, part, use_style

catalogue, registration = part("catalogue"), part("scene.registration")


class RecordingLayout:
    """Stands in for a panel's layout; every sub-panel is open."""

    def __init__(self):
        self.props, self.titles, self.operators, self.curves = [], [], [], []

    def prop(self, owner, name, **_options):
        assert name in owner.bl_rna.properties, name
        self.props.append((owner, name))

    def label(self, text="", **_options):
        self.titles.append(text)

    def operator(self, name, **_options):
        module, _, word = name.partition(".")
        assert hasattr(bpy.types, f"{module.upper()}_OT_{word}"), name
        self.operators.append(name)
        return self

    def operator_menu_enum(self, name, _prop, **_options):
        return self.operator(name)

    def template_ID(self, owner, name, new=""):
        self.prop(owner, name)
        self.operator(new)

    def template_list(self, kind, _id, owner, items, active_owner, active, **_options):
        assert hasattr(bpy.types, kind)
        self.prop(owner, items), self.prop(active_owner, active)

    def separator(self, **_options):
        pass

    def prop_search(self, owner, name, *_where, **_options):
        self.prop(owner, name)

    def template_icon(self, icon_value, scale):
        assert icon_value >= 0 and scale > 1  # 0: Blender has no icons without a window

    def template_icon_view(self, owner, name, **_options):
        assert name in owner.bl_rna.properties, name

    def template_curve_mapping(self, owner, name):
        assert getattr(owner, name).curves
        self.curves.append(getattr(owner, "name", name))  # that of a node, if it is one

    def row(self, **_options):
        return self

    column = grid_flow = box = split = row
    first = index = None  # of operators

    def panel(self, _name, default_closed=False):
        return self, self

    @property
    def shown(self):
        return [name for _, name in self.props]


def full_scene():
    """A scene with everything on that shows more."""
    made = empty_scene()
    made.render.engine = "FOVEA"
    use_style(made, "xray_focus")
    made.fovea.focus_model = "SCENE"
    made.fovea.vectors.title_block = True
    made.fovea.focus_points.add()
    only_lines(made, *(definition["name"] for definition in catalogue.definitions()))
    lines_of(made).hidden.clear()
    add_hidden(lines_of(made)).away = True
    mesh = bpy.data.meshes.new("Mesh")
    obj = bpy.data.objects.new("Object", mesh)
    collection = bpy.data.collections.new("Collection")
    made.collection.children.link(collection)
    collection.objects.link(obj)
    mesh.materials.append(bpy.data.materials.new("Material"))
    bpy.context.view_layer.objects.active = obj
    return made


def context():
    """What Blender hands to panels, wherever they are."""
    obj, scene = bpy.context.object, bpy.context.scene
    return SimpleNamespace(
        scene=scene,
        engine=scene.render.engine,
        object=obj,
        material=obj.active_material,
        collection=obj.users_collection[0],
        view_layer=bpy.context.view_layer,
        window_manager=bpy.context.window_manager,
    )


def shown_by(*classes):
    layout = RecordingLayout()
    for cls in classes or drawn_panels():
        if hasattr(cls, "draw_header"):
            cls.draw_header(SimpleNamespace(layout=layout), context())
        cls.show(cls, layout, context())
    return layout


def drawn_panels():
    modules = [part(name) for name in fovea.MODULES if name.startswith("ui.")]
    shown = [cls for module in modules for cls in registration.classes_of(module) if issubclass(cls, bpy.types.Panel)]
    return [cls for cls in shown if cls.poll(context())]


def leaves(group, path=""):
    """(path, property) of all that a style holds, those of one element of each collection."""
    for prop in group.bl_rna.properties:
        here = f"{path}.{prop.identifier}"
        if prop.identifier == "rna_type" or prop.is_hidden:
            continue
        if prop.type == "POINTER" and issubclass(type(getattr(group, prop.identifier)), bpy.types.PropertyGroup):
            yield from leaves(getattr(group, prop.identifier), here)
        elif prop.type == "COLLECTION":
            for element in getattr(group, prop.identifier):
                yield from leaves(element, here)
        else:
            yield here, prop


def owners(scene):
    """All that has settings of Fovea."""
    obj = bpy.context.object
    return [
        own_style(scene),
        scene.fovea,
        scene.fovea_viewport,
        obj.fovea,
        obj.active_material.fovea,
        obj.users_collection[0].fovea,
        bpy.context.view_layer.fovea,
    ]
