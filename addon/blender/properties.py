"""Settings on scenes, objects and materials. Those of the lines are made from the native registry, which declares them.

scene.fovea has, per line definition, a switch named as it and its parameters as `<definition>_<parameter>`; angles are
stored in radians, as Blender shows them. Choosing a style fills all of them in; then they can be changed.
"""

import math
from dataclasses import replace

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty

from .. import catalogue, native, style
from . import focus_settings, gpu_context, layer_settings, methods, pens
from .property_kinds import color, file_names
from .property_kinds import redraw as _redraw


def definitions():
    """The line definitions; none where the native module is missing, so that files keep their other settings."""
    try:
        return catalogue.definitions()
    except native.Unavailable:
        return ()


def parameter_values(settings, definition):
    """{parameter: value in the registry's unit} of one definition."""
    values = {}
    for parameter in definition["parameters"]:
        value = float(getattr(settings, f"{definition['name']}_{parameter['name']}"))
        values[parameter["name"]] = math.degrees(value) if parameter["unit"] == "degrees" else value
    return values


def style_of(scene):
    """The Style a scene draws with.

    The panel edits the last line set of the chosen style, which draws every line that is switched on; the sets before
    it keep their pens and draw theirs first. Where the style has the same hidden pens, overshoot or halo for one of
    them as for the last, the panel's hold for it, too.
    """
    settings = scene.fovea
    base = style.load(settings.style, definitions() or None)
    kinds = {d["name"]: parameter_values(settings, d) for d in definitions() if getattr(settings, d["name"])}
    old = base.line_sets[-1]
    at_hidden = pens.at_hidden(settings, old)
    before = [
        replace(
            line_set,
            kinds={name: kinds[name] for name in line_set.kinds if name in kinds},
            **{key: value for key, value in at_hidden.items() if getattr(line_set, key) == getattr(old, key)},
        )
        for line_set in base.line_sets[:-1]
    ]
    angle = math.degrees(settings.corner_angle)
    pen, away = pens.pen_of(settings, pens.VISIBLE), focus_settings.line_set_parts(settings)
    last = replace(old, kinds=kinds, corner_angle=angle, pen=pen, **at_hidden, **away)
    transparent = base.paper.transparent or scene.render.film_transparent
    parts = layer_settings.style_parts(settings, base) | focus_settings.style_parts(settings, base)
    parts["paper"] = replace(parts["paper"], color=tuple(settings.paper_color), transparent=transparent)
    return replace(base, line_sets=tuple(s for s in before if s.kinds) + (last,), **parts)


def apply_style(settings, name):
    """Sets everything the panel shows to what the named style says."""
    chosen = style.load(name, definitions() or None)
    kinds = {kind: values for line_set in chosen.line_sets for kind, values in line_set.kinds.items()}
    for definition in definitions():
        setattr(settings, definition["name"], definition["name"] in kinds)
        defaults = {parameter["name"]: parameter["default"] for parameter in definition["parameters"]}
        set_parameters(settings, definition["name"], defaults | kinds.get(definition["name"], {}))
    last = chosen.line_sets[-1]
    settings.corner_angle = math.radians(last.corner_angle)
    settings.paper_color = chosen.paper.color
    pens.set_pen(settings, pens.VISIBLE, last.pen)
    pens.set_hidden(settings, last)
    focus_settings.apply(settings, chosen)
    layer_settings.apply(settings, chosen)


def set_parameters(settings, name, values):
    """Sets parameters of the named definition; values in the registry's units."""
    units = {p["name"]: p["unit"] for d in definitions() if d["name"] == name for p in d["parameters"]}
    for parameter, value in values.items():
        setattr(settings, f"{name}_{parameter}", _stored(value, units[parameter]))


def _stored(value, unit):
    """A parameter's value as its property keeps it."""
    if unit == "bool":
        return bool(value)
    return math.radians(value) if unit == "degrees" else value


def _style_chosen(settings, context):
    apply_style(settings, settings.style)
    _redraw(settings, context)


def _backend_chosen(settings, context):
    if settings.backend == "GPU":
        gpu_context.demand()
    _redraw(settings, context)


def _parameter_property(parameter):
    text = {"name": parameter["label"], "description": parameter["meaning"], "update": _redraw}
    if parameter["unit"] == "bool":
        return BoolProperty(default=bool(parameter["default"]), **text)
    low, default, high = (_stored(parameter[key], parameter["unit"]) for key in ("min", "default", "max"))
    subtype = "ANGLE" if parameter["unit"] == "degrees" else "NONE"
    fine = {"precision": 3, "step": 1} if 0 < default < 0.1 else {}
    return FloatProperty(default=default, min=low, max=high, subtype=subtype, **fine, **text)


def _line_properties(chosen):
    """Annotations for the switches and parameters of all line definitions; on are those the default style has."""
    on = {kind for line_set in chosen.line_sets for kind in line_set.kinds}
    found = {}
    for definition in definitions():
        name = definition["name"]
        text = {"name": definition["label"], "description": f"{definition['description']}.\n{definition['source']}"}
        found[name] = BoolProperty(default=name in on, update=_redraw, **text)
        for parameter in definition["parameters"]:
            found[f"{name}_{parameter['name']}"] = _parameter_property(parameter)
    return found


BACKENDS = [
    ("AUTO", "Automatic", "GPU where it is hardware, else CPU"),
    ("CPU", "CPU", "The same picture on every machine"),
    ("GPU", "GPU", "OpenGL through Blender, in software where there is no hardware"),
]
USAGES = [
    ("BOTH", "Draw and Occlude", "Has lines and hides what lies behind"),
    ("OCCLUDE", "Occlude Only", "Hides what lies behind, has no lines"),
    ("DRAW", "Draw Only", "Has lines and hides nothing"),
    ("IGNORE", "Ignore", "Is not there"),
]
ESTIMATORS = [
    ("AUTOMATIC", "Automatic", "Jets, their degree and rings by how noisy the mesh is"),
    ("JETS", "Jets", "Polynomials fitted to the surroundings of each vertex"),
    ("ONE_RING", "One-Ring", "Differences of normals: fast, for regular meshes"),
]
OCCLUSIONS = [
    ("AUTOMATIC", "Automatic", "Hides what lies behind unless it is transparent or glass"),
    ("ALWAYS", "Always", "Hides what lies behind"),
    ("NEVER", "Never", "Lines behind it show"),
]


def _group(name, annotations):
    return type(name, (bpy.types.PropertyGroup,), {"__annotations__": annotations, "__module__": __name__})


def _scene_group():
    chosen = style.load(style.DEFAULT, definitions() or None)
    last = chosen.line_sets[-1]
    annotations = {
        "backend": EnumProperty(name="Device", items=BACKENDS, update=_backend_chosen),
        **methods.properties(_redraw),
        "style": EnumProperty(
            name="Style", items=file_names(style.names()), default=style.DEFAULT, update=_style_chosen
        ),
        "corner_angle": FloatProperty(
            name="Corner Angle",
            description="Strokes end where a path turns by more than this",
            subtype="ANGLE",
            default=math.radians(last.corner_angle),
            min=0.0,
            max=math.pi,
            update=_redraw,
        ),
        "paper_color": color("Paper", chosen.paper.color, "Colour of the paper"),
    }
    drawn = {**pens.pen_properties(pens.VISIBLE, last.pen, "the strokes"), **pens.hidden_properties(last)}
    drawn |= focus_settings.annotations(chosen) | layer_settings.annotations(chosen)
    return _group("FoveaSceneSettings", {**annotations, **drawn, **_line_properties(chosen)})


def _object_group():
    annotations = {
        "usage": EnumProperty(name="Line Drawing", items=USAGES, update=_redraw),
        "priority": FloatProperty(
            name="Priority",
            description="Of lines that crowd each other, those of objects with more priority stay",
            default=0.5,
            min=0.0,
            max=1.0,
            update=_redraw,
        ),
        "curvature_estimator": EnumProperty(name="Curvature", items=ESTIMATORS, update=_redraw),
        "curvature_rings": IntProperty(
            name="Rings",
            description="How far around each vertex jets are fitted, 0: by how noisy the mesh is",
            min=0,
            max=32,
            update=_redraw,
        ),
        "curvature_smoothing": FloatProperty(
            name="Smoothing",
            description="How far curvature is averaged, in edge lengths; never across hard edges",
            min=0.0,
            max=8.0,
            update=_redraw,
        ),
    }
    return _group("FoveaObjectSettings", {**annotations, **_shape_properties()})


def _shape_properties():
    """What is done to an object's mesh before it is drawn: subdivision.py and repair.py."""
    return {
        "refine": BoolProperty(
            name="Refine",
            description="Draw the smooth surface that subdividing the mesh (Catmull-Clark) for ever would give",
            update=_redraw,
        ),
        "refine_level": IntProperty(
            name="Level",
            description="Each face becomes 2 x 2 per level; at least the levels of a subdivision modifier at the end",
            default=2,
            min=1,
            max=6,
            update=_redraw,
        ),
        "repair_weld": FloatProperty(
            name="Weld",
            description="Vertices that are not farther apart become one",
            subtype="DISTANCE",
            min=0.0,
            precision=4,
            update=_redraw,
        ),
        "repair_orient": BoolProperty(
            name="Face Outwards", description="Turn faces that disagree with their neighbours", update=_redraw
        ),
        "repair_smooth": IntProperty(
            name="Smooth",
            description="Steps of smoothing between creases, marks and borders",
            min=0,
            max=100,
            update=_redraw,
        ),
        "repair_resample": IntProperty(
            name="Resample", description="Steps towards triangles of equal sides", min=0, max=50, update=_redraw
        ),
        "repair_edge_length": FloatProperty(
            name="Edge Length",
            description="Of the triangles; 0: as the mesh has it on average",
            subtype="DISTANCE",
            min=0.0,
            precision=4,
            update=_redraw,
        ),
    }


_registered = []  # (type that has the settings, group)


def register():
    focus_settings.register()
    occlusion = EnumProperty(name="Hides Lines", items=OCCLUSIONS, update=_redraw)
    _registered[:] = [
        (bpy.types.Scene, _scene_group()),
        (bpy.types.Object, _object_group()),
        (bpy.types.Material, _group("FoveaMaterialSettings", {"occlusion": occlusion})),
    ]
    for owner, group in _registered:
        bpy.utils.register_class(group)
        owner.fovea = PointerProperty(type=group)


def unregister():
    for owner, group in reversed(_registered):
        del owner.fovea
        bpy.utils.unregister_class(group)
    _registered.clear()
    focus_settings.unregister()
