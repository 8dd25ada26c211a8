# SPDX-License-Identifier: GPL-3.0-or-later
"""What a style is made of: the paper, the layers under the lines, and an ordered list of line sets with their pens."""

from dataclasses import dataclass, field

from .color import Color
from .elision import Elision
from .focus import Distance, Effects, Focus
from .stages import REFERENCE_HEIGHT, Pen
from .style_json import dotted

# Of a LineSet: what each is called where it is turned round.
FILTERS = {"collection": "outside", "object": "other_objects", "material": "other_materials"}


@dataclass(frozen=True)
class Paper:
    color: tuple = (1.0, 1.0, 1.0)  # scene-linear
    transparent: bool = False
    texture: str = "none"  # a file of addon/papers, without .png; none: smooth
    scale: float = 1.0  # reference pixels that a texel of the texture covers
    tooth: float = 0.0  # how far thin ink stays on the heights of the paper
    granulation: float = 0.0  # how much more pigment of the colour layer its valleys take
    tint: float = 0.0  # how much its relief shades the whole picture
    height_mm: float = 210.0  # of the page, for pens measured in millimetres; that of A4 lying


@dataclass(frozen=True)
class Hidden:
    """How the parts of lines are drawn that at least `first` and at most `last` surfaces hide (None: any number)."""

    pen: Pen = Pen()
    first: int = 1
    last: int | None = None
    pen_away: Pen | None = None  # out of focus; None: as in focus


@dataclass(frozen=True)
class LineSet:
    """Lines drawn alike. An edge goes to the first set of the style that has a line for it."""

    name: str = "lines"
    kinds: dict = field(default_factory=dict)  # {definition id: {parameter: value}}, in the registry's units
    collection: str = ""  # of Blender: only its objects have these lines; none: all have
    outside: bool = False  # only what is not in it has them
    object: str = ""  # of Blender: only it, and instances that it makes or that are of it, have these lines; none: all
    other_objects: bool = False  # only what is not it has them
    material: str = ""  # of Blender: only faces of it have these lines; none: all
    other_materials: bool = False  # only faces of others have them
    corner_angle: float = 60.0  # degrees of turn at which a path is split
    least_length: float = 30.0  # reference pixels; shorter lines with an end that touches no other are left out
    overshoot: float = 0.0  # reference pixels that lines go on beyond their ends, where nothing hides these
    halo: float = 0.0  # reference pixels of gap where visible parts pass behind others
    overshoot_away: float | None = None  # the same out of focus; None: as in focus
    pen: Pen = Pen()  # of visible parts
    pen_away: Pen | None = None  # of visible parts out of focus; None: as in focus
    hidden: tuple = ()  # of Hidden, ranges that do not overlap; parts in none of them are not drawn


@dataclass(frozen=True)
class Style:
    paper: Paper = Paper()
    line_sets: tuple = (LineSet(),)
    focus: Focus = Focus()
    effects: Effects = Effects()
    distance: Distance = Distance()
    color: Color = Color()
    elision: Elision = Elision()
    kept: tuple = ()  # of (path, JSON value): what its file says that this version does not know, for `dump`

    def has_color(self):
        """Whether there is a colour layer."""
        return self.color.shading != "plain" and self.effects.colors != "none"

    def pen_pairs(self):
        """(pen in focus, pen out of focus or None): those of visible parts by line set, then those of hidden parts."""
        visible = [(s.pen, s.pen_away) for s in self.line_sets]
        return visible + [(hidden.pen, hidden.pen_away) for s in self.line_sets for hidden in s.hidden]

    def pens(self):
        """All pens: those in focus as in `pen_pairs`, then those out of focus."""
        pairs = self.pen_pairs()
        return [pen for pen, _ in pairs] + [away for _, away in pairs if away]

    def width_px(self, pen, scale):
        """Width of a pen in pixels of the image, `scale` of which are a reference pixel."""
        millimetre = REFERENCE_HEIGHT * scale / self.paper.height_mm
        return pen.width * {"reference": scale, "pixels": 1.0, "millimetres": millimetre}[pen.width_unit]

    @property
    def unknown(self):
        """The dotted names of what is kept without being known."""
        return tuple(dotted(path) for path, _ in self.kept)
