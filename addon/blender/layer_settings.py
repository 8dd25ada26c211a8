"""Colour, paper and elision of a style, as properties of the scene: one for each number, switch and choice of them."""

from dataclasses import replace

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty

from .. import color, elision, style
from .property_kinds import color as color_property
from .property_kinds import attribute_name, file_names, number, redraw

SHADINGS = [
    ("PLAIN", "Paper", "No colours: the paper alone lies under the lines"),
    ("FLAT", "Flat", "Base colours of the materials"),
    ("SMOOTH", "Smooth", "Lit by the scene's lights, or by one at the camera"),
    ("TOON", "Toon", "Lit in bands"),
]
NUMBERS = {  # property: (part of a Style, its field, name, description)
    "color_opacity": ("color", "opacity", "Opacity", "Opacity of the colours"),
    "color_desaturation": ("color", "desaturation", "Desaturation", "How grey colours are everywhere"),
    "paper_scale": ("paper", "scale", "Grain Size", "Size of the paper's grain"),
    "paper_tooth": ("paper", "tooth", "Tooth", "How far ink stays off the valleys of the paper"),
    "paper_granulation": ("paper", "granulation", "Granulation", "How far colour settles in the valleys of the paper"),
    "paper_height_mm": ("paper", "height_mm", "Height in mm", "Height of the page, for pens measured in millimetres"),
    "paper_tint": ("paper", "tint", "Relief", "How far the paper's own relief shows"),
}
WEIGHTS = {
    "length": "how long it is in space",
    "kind": "what it is: outlines before creases before lines on smooth surfaces",
    "strength": "how strong it is",
    "depth": "how near it is",
    "object": "the priority of its object",
    "painted": "what is painted on its mesh",
}
ATTRIBUTES = {
    "priority_attribute": ("Painted Priority", "Attribute of meshes: lines where it is white stay, half way where there is none"),
    "density_attribute": (
        "Painted Density",
        "Attribute of meshes: lines are four times as dense where it is white, a quarter as dense where it is black",
    ),
}


def annotations(chosen):
    """Annotations of the scene's settings, by a Style's defaults."""
    found = {
        "color_shading": EnumProperty(
            name="Colour", items=SHADINGS, default=chosen.color.shading.upper(), update=redraw
        ),
        "color_bands": IntProperty(
            name="Bands",
            description="Of toon shading",
            default=chosen.color.bands,
            min=2,
            max=color.MOST_BANDS,
            update=redraw,
        ),
        "color_on_paper": BoolProperty(
            name="On Paper",
            description="Where there is nothing, and where colours fade, the paper shows",
            default=chosen.color.background is None,
            update=redraw,
        ),
        "color_background": color_property(
            "Background", chosen.color.background or (1.0, 1.0, 1.0), "Colour behind everything, towards which colours fade"
        ),
        "paper_texture": EnumProperty(
            name="Paper",
            description="Height of the paper, which ink and colour heed",
            items=file_names(style.papers()),
            default=chosen.paper.texture,
            update=redraw,
        ),
        "elision": BoolProperty(
            name="Elision",
            description="Thin lines that go alongside each other nearer than their pens' spacing",
            default=chosen.elision.enabled,
            update=redraw,
        ),
        "elision_fade_from": FloatProperty(
            name="Least Room",
            description="Share of its room that a line must have to show at all",
            default=chosen.elision.fade_from,
            min=0.0,
            max=0.99,
            update=redraw,
        ),
        "elision_cut": FloatProperty(
            name="Least Opacity",
            description="Lines that are fainter are left out altogether",
            default=chosen.elision.cut,
            min=0.0,
            max=0.99,
            update=redraw,
        ),
    }
    found["elision_frames"] = IntProperty(
        name="Frames",
        description="Renders smooth how lines come and go over so many frames before and after each, which takes as much "
        "longer; not lines that change with the view",
        default=chosen.elision.frames,
        min=0,
        max=elision.MOST_FRAMES,
        update=redraw,
    )
    found["elision_density_image"] = PointerProperty(
        type=bpy.types.Image,
        name="Density Map",
        description="Image over the camera's frame: lines are four times as dense where it is white, a quarter as dense "
        "where it is black",
        update=redraw,
    )
    for name, (label, told) in ATTRIBUTES.items():
        found[f"elision_{name}"] = attribute_name(label, told, getattr(chosen.elision, name))
    for name, (part, field, label, told) in NUMBERS.items():
        found[name] = number(label, field, getattr(getattr(chosen, part), field), told)
    for term, told in WEIGHTS.items():
        found[f"elision_{term}"] = FloatProperty(
            name=term.title(),
            description=f"Of the lines that crowd each other, which stay: how much counts {told}",
            default=getattr(chosen.elision, term),
            min=0.0,
            max=elision.MOST_WEIGHT,
            soft_max=2.0,
            update=redraw,
        )
    return found


def style_parts(settings, base):
    """{field of Style: value} of what the panel says, but for the paper's colour; the rest as in `base`."""
    background = None if settings.color_on_paper else tuple(settings.color_background)
    shading, bands = settings.color_shading.lower(), settings.color_bands
    weights = {term: getattr(settings, f"elision_{term}") for term in WEIGHTS}
    names = {name: getattr(settings, f"elision_{name}") for name in ATTRIBUTES}
    shares = settings.elision_fade_from, settings.elision_cut
    thinning = elision.Elision(settings.elision, *shares, settings.elision_frames, **weights, **names)
    if not any(thinning.weights().values()):
        thinning = replace(thinning, length=1.0)
    return {
        "color": replace(base.color, shading=shading, bands=bands, background=background, **_numbers(settings, "color")),
        "paper": replace(base.paper, texture=settings.paper_texture, **_numbers(settings, "paper")),
        "elision": thinning,
    }


def apply(settings, chosen):
    """Sets the properties to what a Style says."""
    settings.color_shading, settings.color_bands = chosen.color.shading.upper(), chosen.color.bands
    settings.color_on_paper = chosen.color.background is None
    if chosen.color.background is not None:
        settings.color_background = chosen.color.background
    settings.paper_texture = chosen.paper.texture
    for name, (part, field, *_) in NUMBERS.items():
        setattr(settings, name, getattr(getattr(chosen, part), field))
    settings.elision = chosen.elision.enabled
    settings.elision_fade_from, settings.elision_cut = chosen.elision.fade_from, chosen.elision.cut
    settings.elision_frames = chosen.elision.frames
    for name in (*WEIGHTS, *ATTRIBUTES):
        setattr(settings, f"elision_{name}", getattr(chosen.elision, name))


def _numbers(settings, wanted):
    return {field: getattr(settings, name) for name, (part, field, *_) in NUMBERS.items() if part == wanted}
