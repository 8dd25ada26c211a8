# SPDX-License-Identifier: GPL-3.0-or-later
"""Observes the add-on in its viewports: how often it draws and reads the scene, and when it has finished."""

from the_addon import part
from window import screen

viewport, session, Budget = part("render.viewport"), part("render.session"), part("budget").Budget


class Watch:
    """Counts, from when it is made, until `end`."""

    def __init__(self):
        self.kept = {}  # region -> its Viewport, of those drawn
        self._old = viewport.draw, session.gather, Budget.choose
        viewport.draw, session.gather = self._draw, self._gather
        Budget.choose = lambda *arguments, **options: self._choose(*arguments, **options)
        self.reset()

    def reset(self):
        self.draws = self.read = 0
        self.drafts = []  # qualities that were chosen while something changed; 0 is the best

    def end(self):
        viewport.draw, session.gather, Budget.choose = self._old

    def _draw(self, engine, context, depsgraph):
        self._old[0](engine, context, depsgraph)
        self.draws += 1
        self.kept[context.region.as_pointer()] = engine.viewport

    def _choose(self, *arguments, **options):
        self.drafts.append(self._old[2](*arguments, **options))
        return self.drafts[-1]

    def _gather(self, *arguments, **options):
        self.read += 1
        return self._old[1](*arguments, **options)

    def of(self, area):
        """The Viewport of an area; None before it was drawn."""
        return self.kept.get(screen.region(area).as_pointer())

    def refined(self, *areas):
        """Waits until viewports (the first, when none is named) show their best: `yield from` it."""
        yield from screen.rest(0.1)  # what was just done is noticed when Blender draws
        chosen = areas or (screen.area(),)

        def final():
            return all(self.of(a) and self.of(a).is_final() for a in chosen)

        def shown():
            if not final():
                return False
            screen.swap()
            return final()  # that draw may be the first to notice what was done

        yield from screen.until(shown)
