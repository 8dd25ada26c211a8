# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside a Blender with a window: blender --enable-event-simulate -P inside.py -- FILE SCENARIO OUT.json WORDS...

A scenario is a generator function of the file: it does something, then yields, and goes on after Blender has handled
events and drawn. What it returns is written as JSON; so is what goes wrong. A timer drives it, as a timer is where
Blender is between two pictures; a window's state must never be asked for in background mode."""

import faulthandler
import importlib
import json
import os
import sys
import traceback
from pathlib import Path

import bpy

sys.path.append(str(Path(__file__).parents[1]))
bpy.context.preferences.view.show_splash = False
bpy.context.preferences.use_preferences_save = False

faulthandler.dump_traceback_later(float(os.environ["FOVEA_SECONDS"]), exit=True)  # where it hangs, if it does

TICK = 0.01  # seconds


def drive(scenario, out):
    """Takes the generator one step further whenever Blender has time."""

    def tick():
        try:
            pause = next(scenario)
            return TICK if pause is None else pause
        except StopIteration as end:
            told = {"result": end.value}
        except Exception:
            told = {"error": traceback.format_exc()}
        Path(out).write_text(json.dumps(told))
        bpy.ops.wm.quit_blender()
        return None

    bpy.app.timers.register(tick, first_interval=0.5, persistent=True)


def scenario_of(file, name, folder, words):
    """The scenario called `name` of a file, so that its import, too, happens where errors are told."""
    sys.path.insert(0, str(Path(file).parent))
    return (yield from getattr(importlib.import_module(Path(file).stem), name)(folder, *words))


def main(file, name, out, *words):
    drive(scenario_of(file, name, Path(out).parent, words), out)


main(*sys.argv[sys.argv.index("--") + 1 :])
