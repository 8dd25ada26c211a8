# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside a Blender with a window: blender --enable-event-simulate -P inside.py -- FILE SCENARIO OUT.json WORDS...

A scenario is a generator function in the file: at each yield, Blender handles events and draws. Its result, or the
traceback of an exception, is written as JSON. A timer drives it, because timers run between two redraws; window state
must not be accessed in background mode."""

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

faulthandler.dump_traceback_later(float(os.environ["FOVEA_SECONDS"]), exit=True)  # traceback if it hangs

TICK = 0.01  # seconds


def drive(scenario, out):
    """Advances the generator by a timer; a yielded number is the pause in seconds. Writes the result and quits
    Blender."""

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
    """The scenario `name` of a file, as a generator, so that errors of its import are reported as well."""
    sys.path.insert(0, str(Path(file).parent))
    return (yield from getattr(importlib.import_module(Path(file).stem), name)(folder, *words))


def main(file, name, out, *words):
    drive(scenario_of(file, name, Path(out).parent, words), out)


main(*sys.argv[sys.argv.index("--") + 1 :])
