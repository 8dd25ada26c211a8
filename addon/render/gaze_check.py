# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks by salience whether eyes go to the focus of a scene, as a final render of it would have it, and finds how
much emphasis that takes. Pictures are drawn as large as the models of salience look at them, and without
frames around them, which Temporal Smoothing would need."""

from dataclasses import dataclass
from functools import partial

from .. import gaze, native, style
from ..scene.problem import CannotDraw
from . import as_rendered, properties, session

NO_FOCUS = "There is no focus yet: pick one first"


@dataclass(frozen=True)
class Checked:
    """Where eyes go in a drawing of a scene."""

    gaze: gaze.Gaze
    names: tuple  # of the objects at its places; "": none
    judged: gaze.Judged | None  # None: there is no place to look at

    @property
    def sentence(self):
        return gaze.sentence(self.gaze, self.names, self.judged)

    @property
    def told(self):
        return gaze.told(self.gaze, self.names, self.judged)


class NeverWins(CannotDraw):
    """The focus does not win, whatever the emphasis."""


def check(context, tell=None):
    """The Checked of the context's scene; `tell` as for `session.final`. CannotDraw if the user canceled it."""
    return _looked(context, lambda drawing: drawing.checked(), tell)


def strengthen(context, tell=None):
    """(emphasis, Checked) of the least emphasis, from that of the scene's style on, at which the focus wins.
    NeverWins, with what the eye goes to, if it does not at any."""

    def search(drawing):
        now = drawing.chosen.effects.emphasis
        before = drawing.checked()
        if before.judged is None:
            raise CannotDraw(NO_FOCUS)
        if before.judged.wins:
            return now, before
        emphasis, found = gaze.strengthened(drawing.checked, now, most_emphasis())
        if not found.judged.wins:
            raise NeverWins(
                f"{found.sentence}, even with the most emphasis: let more effects answer to focus, or move it"
            )
        return emphasis, found

    return _looked(context, search, tell)


def strengthen_over(context, frames, tell):
    """(emphasis by frame, frames at which the focus never wins) of some frames; the scene stays at its frame. NeverWins
    if it does at none of them."""
    scene, by_frame, lost = context.scene, {}, []
    now, subframe = scene.frame_current, scene.frame_subframe
    try:
        for number, frame in enumerate(frames):
            scene.frame_set(frame)
            try:
                by_frame[frame], _ = strengthen(
                    context, lambda share, text, number=number: tell((number + share) / len(frames), text)
                )
            except NeverWins as reason:
                lost.append(frame)
                last = reason
    finally:
        scene.frame_set(now, subframe=subframe)
    if not by_frame:
        raise NeverWins(f"Frame {lost[-1]}: {last}") from last
    return by_frame, lost


def most_emphasis():
    return style.field(style.Effects, "emphasis")["max"]


def evenly(chosen):
    """A Style with focus the same all over, whatever its emphasis."""
    return chosen.replace(effects=chosen.effects.replace(lines="uniform", colors="uniform", emphasis=1.0))


def look(image, frame):
    """(Gaze, names of the objects at its places) of an Image and the Frame that it was drawn by."""
    seen = gaze.look(native.load().displayed(image.combined))
    return seen, tuple(frame.object_at(tuple(place), seen.radius) for place in seen.places)


class _Drawing:
    """A Read scene in a View, to be drawn with varying emphasis; arguments as for `session.draw`."""

    def __init__(self, found, seen, chosen, backend, options, progress, cancel, _near):
        self.chosen = chosen
        beside = {"backend": backend, "options": options, "progress": progress, "cancel": cancel}
        self._draw = partial(session.draw, found, seen, **beside)
        self._evenly = None

    def checked(self, emphasis=None):
        """The Checked of the drawing; None: of the style's own emphasis."""
        effects = self.chosen.effects if emphasis is None else self.chosen.effects.replace(emphasis=emphasis)
        image, (seen, names) = self._looked(self.chosen.replace(effects=effects))
        if image.focus is None:
            return Checked(seen, names, None)
        if self._evenly is None:
            _, (self._evenly, _) = self._looked(evenly(self.chosen))
        return Checked(seen, names, gaze.judge(seen, self._evenly, image.focus))

    def _looked(self, chosen):
        frames = []
        image = self._draw(chosen=chosen, also=frames.append)
        return image, look(image, frames[0])


def _looked(context, work, tell):
    """work(_Drawing) of a final render of the context's view layer."""
    own = properties.style_of(context.scene)
    still = own.animation.replace(visibility_frames=0, marks_frames=0, marks_baked=False)
    chosen = own.replace(elision=own.elision.replace(frames=0), animation=still)

    def make(*arguments):
        return work(_Drawing(*arguments))

    made = as_rendered.look(context, partial(session.final, make=make, chosen=chosen, tell=tell), _as_looked_at)
    if made is None:
        raise CannotDraw("Stopped before the lines were drawn")
    return made[1]


def _as_looked_at(scene):
    """Sets a copy of a scene to the whole frame, as large as it is looked at, but not larger than it is."""
    render = scene.render
    own = (side * render.resolution_percentage / 100 for side in (render.resolution_x, render.resolution_y))
    render.resolution_x, render.resolution_y = gaze.frame_size(*own)
    render.resolution_percentage, render.use_border = 100, False
