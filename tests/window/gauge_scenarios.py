# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of gauges that are set in an image editor, with pointer events, in a window; see inside.py. Tests check
what a scenario returns."""

import hashlib
import json
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "blender"))

import bpy
import numpy as np
from pointer import drag, event, press
from the_addon import part
from window import screen

setting, native = part("ui.gauge_setting"), part("native")
gauges, gauge_practice = part("gauges"), part("gauge_practice")
SIZE, RADIUS = (320, 240), 20.0
PLACES = [(60.5, 60.0), (160.0, 120.0), (250.0, 180.5)]
OFFSETS = [(12, 5), (-18, -9), (3, 25), (0, -30), (22, -22), (-33, 2)]  # pixels of the picture, y up


def study(folder):
    """A study of a gray picture; its study.json."""
    content = native.load().png_bytes(np.full((*SIZE[::-1], 3), 150, np.uint8))
    (folder / "plain.png").write_bytes(content)
    told = {"study": "abc", "build": "test", "model": "gray", "size": SIZE, "radius": RADIUS}
    told["stimuli"] = [{"style": "plain", "file": "plain.png", "sha256": hashlib.sha256(content).hexdigest()}]
    told["gauges"] = [{"x": x, "y": y, "n": [0.0, 0.6, 0.8]} for x, y in PLACES]
    path = folder / "study.json"
    path.write_text(json.dumps(told))
    return path


def editor():
    """The (area, region) of the image editor."""
    area = next(a for a in bpy.context.window_manager.windows[0].screen.areas if a.type == "IMAGE_EDITOR")
    return area, next(region for region in area.regions if region.type == "WINDOW")


def override():
    area, region = editor()
    window = bpy.context.window_manager.windows[0]
    return bpy.context.temp_override(window=window, screen=window.screen, area=area, region=region)


def invoked(path, **words):
    with override():
        return list(bpy.ops.fovea.set_gauges(filepath=str(path), **words))


def window_px(px, size=SIZE):
    """Pixels of the window, of pixels (x, y) of the picture from the upper left."""
    region = editor()[1]
    x, y = region.view2d.view_to_region(px[0] / size[0], 1 - px[1] / size[1], clip=False)
    return region.x + x, region.y + y


def turned(session, offset):
    """Drags the gauge that is shown."""
    (x, y), size = session.place, session.study.size
    ends = ((x + 4, y), (x + offset[0], y - offset[1]))
    yield from drag("LEFTMOUSE", *(window_px(end, size) for end in ends), 4)


def colored(color):
    """(n, 2) pixels of the editor's region, x and y, that have a color."""
    region = editor()[1]
    with override():
        bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1)
    shown = screen.whole()[region.y : region.y + region.height, region.x : region.x + region.width]
    rows, columns = np.nonzero((np.abs(shown[..., :3] - color) < 0.15).all(axis=2))
    return np.stack([columns, rows], axis=1)


def green():
    return colored(setting.COLOR[:3])


def orange():
    return colored(setting.OFF[:3])


def offset_of(n):
    """Where a gauge of the practice is dragged to, in pixels from its middle, y up, to have a normal."""
    slant = np.degrees(np.arccos(n[2])) * 90 / gauges.STEEPEST
    return 2 * gauges.EXAMPLE["radius"] * np.sin(np.radians(slant)) * np.array(n[:2]) / np.hypot(*n[:2])


def practice(folder):
    """Someone new practices, stops, and practices again, whereupon the session begins."""
    path = study(folder)
    yield from screen.fill()
    bpy.context.window_manager.windows[0].screen.areas[0].type = "IMAGE_EDITOR"
    yield from screen.rest(0.3)
    images = set(bpy.data.images.keys())
    told = {"begun": invoked(path)}
    yield from screen.rest(0.3)
    yield from event("ESC", "PRESS", window_px((10, 10)))
    yield from screen.rest(0.2)
    told["stopped"] = [sorted(set(bpy.data.images.keys()) - images), list(setting.last)]
    invoked(path)
    yield from screen.rest(0.3)
    (shape,) = (image for image in bpy.data.images if image.name.startswith("Gauge Practice"))
    told["size"], told["seen"] = list(shape.size), []
    trial = gauge_practice.Practice()
    for place in gauges.EXAMPLE["places"]:
        offset = offset_of(gauges.normal_of_example(place))
        for of in (-offset, offset):  # the other way, and then as the shape lies
            trial.at = gauges.EXAMPLE["places"].index(place)
            yield from turned(trial, of)
            told["seen"].append([len(green()) > 0, len(orange()) > 0])
        yield from press("SPACE", window_px((10, 10)))
    yield from screen.rest(0.2)
    shown = setting.last["abc"]
    told["session"] = [shown.at, shown.count, editor()[0].spaces.active.image.name]
    told["images"] = sorted(set(bpy.data.images.keys()) - images)
    yield from turned(shown, OFFSETS[0])
    yield from press("SPACE", window_px((10, 10)))
    yield from event("ESC", "PRESS", window_px((10, 10)))
    yield from screen.rest(0.2)
    told["lines"] = [json.loads(line) for line in shown.path.read_text().splitlines()]
    return told


def session(folder):
    """One sets gauges, goes back once, stops, goes on, and sets all; what is seen meanwhile, and what is saved."""
    path = study(folder)
    yield from screen.fill()
    bpy.context.window_manager.windows[0].screen.areas[0].type = "IMAGE_EDITOR"
    yield from screen.rest(0.3)
    told = {"begun": invoked(path, practice=False)}
    yield from screen.rest(0.3)
    shown, region = setting.last["abc"], editor()[1]
    yield from press("SPACE", window_px((10, 10)))
    told["untouched"] = shown.at
    for i in range(3):
        yield from turned(shown, OFFSETS[i])
        if i == 0:
            middle = np.array(window_px(shown.place)) - (region.x, region.y)
            away = green() - middle
            np.save(folder / "gauge.npy", screen.whole())
            told["seen"] = [away.min(axis=0).tolist(), away.max(axis=0).tolist()]
            low, high = window_px((0, 0)), window_px(SIZE)
            told["scale"] = (high[0] - low[0]) / SIZE[0]
        yield from press("SPACE" if i else "RET", window_px((10, 10)))
    yield from press("BACK_SPACE", window_px((10, 10)))
    told["back"] = shown.at
    yield from press("SPACE", window_px((10, 10)))
    yield from event("ESC", "PRESS", window_px((10, 10)))
    yield from screen.rest(0.2)
    told["stopped"] = [shown.count, len(green()), len(shown.path.read_text().splitlines())]
    invoked(path)
    yield from screen.rest(0.2)
    told["same"] = setting.last["abc"] is shown
    while not shown.done:
        yield from turned(shown, OFFSETS[shown.at])
        yield from press("SPACE", window_px((10, 10)))
    yield from screen.rest(0.2)
    told["end"] = [shown.count, len(green())]
    told["lines"] = [json.loads(line) for line in shown.path.read_text().splitlines()]
    told["files"] = sorted(file.name for file in folder.glob("*.jsonl"))
    return told
