# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of many operations with undo and redo. Tests check what a scenario returns."""

import random
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "blender"))

import bpy
import numpy as np
import operations
import our_operations
from showing import calm, opened
from window import screen

ALL = {"OBJECT": operations.WORKING + our_operations.WORKING, "EDIT_MESH": operations.EDITING}
OFTEN = 5  # steps between pictures that are compared on the way back and forth


class Deck:
    """Operations as cards, shuffled; what cannot be done now waits for a later turn."""

    def __init__(self, seed):
        self.lot = random.Random(seed)
        self._piles = {"EDIT_MESH": [], "OBJECT": []}

    def act(self):
        """Does one thing; its name."""
        mode = bpy.context.mode
        pile = self._piles[mode]
        for card in pile:
            if card(self.lot):
                pile.remove(card)
                return card.__name__
        pile += self.lot.sample(ALL[mode], len(ALL[mode]))
        return self.act()


def many(folder, seed, count):
    """So many operations drawn by lot, all undone, all done again: names, in how many the picture changed, and those
    steps after which it is another than it was there the first time."""
    count, deck, names = int(count), Deck(int(seed)), []
    bpy.context.preferences.edit.undo_steps = 2 * count
    watch = yield from opened("boxes:2")
    screen.space().region_3d.view_distance = 12
    yield from watch.refined()
    with screen.override():
        bpy.ops.ed.undo_push(message="start")
    pictures = [screen.picture()[16:]]
    for _ in range(count):
        with screen.override():
            names.append(deck.act())
        yield from watch.refined()
        pictures.append(screen.picture()[16:])
    told = {"names": names, "changed": sum(bool((a != b).any()) for a, b in zip(pictures, pictures[1:]))}
    told["undone"] = yield from go(watch, bpy.ops.ed.undo, range(count - 1, -1, -1), pictures, names, folder)
    told["redone"] = yield from go(watch, bpy.ops.ed.redo, range(1, count + 1), pictures, names, folder)
    return told | {"calm": (yield from calm())}


def go(watch, step, places, pictures, names, folder):
    """Takes a step to each of the places; [place, name, difference] where the picture there is another; both are kept
    in the folder."""
    wrong = []
    for place in places:
        with screen.override():
            step()
        if place % OFTEN and place != places[-1]:
            yield  # on, as when the keys are held down
            continue
        yield from watch.refined()
        difference = float(np.abs(screen.picture()[16:] - pictures[place]).mean())
        if difference > 1e-5:
            wrong.append([place, names[max(place - 1, 0)], difference])
            np.save(folder / f"{step.idname_py()}_{place}.npy", np.stack((pictures[place], screen.picture()[16:])))
    return wrong
