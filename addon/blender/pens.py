"""The two pens of the panel, for visible and for hidden parts of lines, and what happens where lines become hidden."""

from dataclasses import fields

from bpy.props import BoolProperty, EnumProperty, IntProperty

from .. import style
from ..stages import Pen
from .property_kinds import color, file_names, number, redraw

VISIBLE, HIDDEN = "pen", "hidden_pen"  # what the names of the pens' properties begin with
FIELDS = (
    *("color", "opacity", "width", "width_unit", "texture", "texture_anchor", "length_scale", "cap", "taper"),
    *("strength_width", "wobble", "wobble_length", "seed", "pressure", "spacing"),
)


CHOICES = {  # field: (name, description, items)
    "cap": (
        "Ends",
        "Ends of {}",
        [("ROUND", "Round", "Half a disc beyond each end"), ("BUTT", "Butt", "Cut off straight at each end")],
    ),
    "width_unit": (
        "Unit",
        "What the width of {} is measured in",
        [
            ("REFERENCE", "Reference Pixels", "Pixels of an image 1080 pixels high: alike at any resolution"),
            ("PIXELS", "Pixels", "Pixels of the image, however large it is"),
            ("MILLIMETRES", "Millimetres", "Millimetres on a page as high as the paper says"),
        ],
    ),
    "texture_anchor": (
        "Texture Keeps",
        "What the texture of {} keeps when they grow in the image",
        [
            ("SCREEN", "Its Size", "One repetition is always as long in the image, and slides along lines that grow"),
            ("PATH", "Its Place", "It stays where it is along lines, and divides as they grow: for grain, not for dashes"),
        ],
    ),
}


def at_hidden(settings, line_set):
    """{field of LineSet: value} of what the panel says of hidden parts. Beyond its first range, and out
    of focus, the style's line set keeps its hidden pens."""
    hidden = ()
    if settings.hidden:
        away = line_set.hidden[0].pen_away if line_set.hidden else None
        first = style.Hidden(pen_of(settings, HIDDEN), settings.hidden_from, settings.hidden_to or None, away)
        hidden = (first, *line_set.hidden[1:])
    return {"hidden": hidden, "overshoot": settings.overshoot, "halo": settings.halo}


def set_hidden(settings, line_set):
    settings.overshoot, settings.halo, settings.hidden = line_set.overshoot, line_set.halo, bool(line_set.hidden)
    hidden = _first_hidden(line_set)
    set_pen(settings, HIDDEN, hidden.pen)
    settings.hidden_from, settings.hidden_to = hidden.first, hidden.last or 0


def _first_hidden(line_set):
    """The first of a line set's hidden pens, or what to offer where it has none: dashes, however much is hidden."""
    return line_set.hidden[0] if line_set.hidden else style.Hidden(style.dashed(line_set.pen))


def pen_of(settings, prefix):
    """The Pen that the properties of a prefix describe."""
    values = {f.name: getattr(settings, f"{prefix}_{f.name}") for f in fields(Pen)}
    return Pen(**values | {"color": tuple(values["color"])} | {name: values[name].lower() for name in CHOICES})


def set_pen(settings, prefix, pen):
    for f in fields(Pen):
        value = getattr(pen, f.name)
        setattr(settings, f"{prefix}_{f.name}", value.upper() if f.name in CHOICES else value)


def pen_properties(prefix, pen, what):
    """Annotations for a pen that draws `what`, each named by the prefix and the pen's field."""
    numbers = {
        "opacity": ("Opacity", f"Opacity of {what}"),
        "width": ("Width", f"Width of {what}, by default in pixels of an image 1080 pixels high"),
        "length_scale": ("Stretch", f"Stretches the texture along {what}"),
        "taper": ("Taper", f"Length of the thinning ends of {what}, in pixels of an image 1080 pixels high"),
        "wobble": ("Wobble", f"How far {what} stray, in pixels of an image 1080 pixels high"),
        "wobble_length": ("Wave Length", f"Length of the waves in which {what} stray, in pixels of an image 1080 high"),
        "seed": ("Seed", "Another number is another hand"),
        "pressure": ("Pressure", f"How much thinner {what} are at their ends than in the middle"),
        "spacing": ("Spacing", f"Where elision is on: how near {what} may be to each other, in pixels of an image 1080 high"),
        "strength_width": ("Thin by Strength", f"How far weak ones among {what} are thin, not pale"),
    }
    found = {
        "color": color("Color", pen.color, f"Colour of {what}"),
        "texture": EnumProperty(
            name="Texture",
            description=f"Ink of {what}, repeated along them",
            items=file_names(style.textures()),
            default=pen.texture,
            update=redraw,
        ),
    }
    for field, (name, told, items) in CHOICES.items():
        default = getattr(pen, field).upper()
        found[field] = EnumProperty(
            name=name, description=told.format(what), items=items, default=default, update=redraw
        )
    found |= {field: number(name, field, getattr(pen, field), told) for field, (name, told) in numbers.items()}
    return {f"{prefix}_{field}": found[field] for field in FIELDS}


def hidden_properties(line_set):
    """Annotations for what happens where lines become hidden."""
    hidden = _first_hidden(line_set)
    return {
        "hidden": BoolProperty(
            name="Hidden Lines",
            description="Draw what surfaces hide, with a pen of its own and below the visible lines",
            default=bool(line_set.hidden),
            update=redraw,
        ),
        "hidden_from": IntProperty(
            name="From",
            description="Draw lines that at least so many surfaces hide",
            default=hidden.first,
            min=1,
            max=style.MOST_SURFACES,
            update=redraw,
        ),
        "hidden_to": IntProperty(
            name="To",
            description="Draw lines that at most so many surfaces hide; 0: any number",
            default=hidden.last or 0,
            min=0,
            max=style.MOST_SURFACES,
            update=redraw,
        ),
        "halo": number(
            "Halo",
            "halo",
            line_set.halo,
            "Gap that is left in lines where they pass behind others, in pixels of an image 1080 pixels high",
        ),
        "overshoot": number(
            "Overshoot",
            "overshoot",
            line_set.overshoot,
            "How far lines go on beyond their ends and behind what hides them, in pixels of an image 1080 pixels high",
        ),
        **pen_properties(HIDDEN, hidden.pen, "hidden lines"),
    }
