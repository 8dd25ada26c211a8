# SPDX-License-Identifier: GPL-3.0-or-later
"""Two pools of threads on the same cores: Fovea draws while Cycles renders in the same process. A self-contained module
has a pool of its own, that of a suite shares Blender's."""

import threading

import addon_utils
import bpy
import numpy as np
import pytest
from pictures import box_scene
from the_addon import part

style, style_picture = part("style"), part("style.style_picture")
AT_ONCE = 2  # threads that draw


def cycles_picture(path, meanwhile=None):
    """Pixels of the scene by Cycles; meanwhile() runs in threads of its own while it renders."""
    render = bpy.context.scene.render
    render.engine, render.filepath = "CYCLES", str(path)
    render.resolution_x, render.resolution_y, render.resolution_percentage = 200, 120, 100
    cycles = bpy.context.scene.cycles
    cycles.device, cycles.samples, cycles.use_denoising = "CPU", 48, False  # not every Cycles can denoise
    threads = [threading.Thread(target=meanwhile) for _ in range(AT_ONCE if meanwhile else 0)]
    for thread in threads:
        thread.start()
    try:
        bpy.ops.render.render(write_still=True)
    finally:
        if meanwhile:
            meanwhile.over.set()
        for thread in threads:
            thread.join()
    image = bpy.data.images.load(render.filepath)
    pixels = np.array(image.pixels[:])
    bpy.data.images.remove(image)
    return pixels


class Drawing:
    """Draws the same picture again and again until it is over."""

    def __init__(self):
        self.over, self.pictures, self.errors = threading.Event(), [], []

    def __call__(self):
        try:
            while not self.over.is_set():
                self.pictures.append(style_picture.draw(style.load("watercolor")))
        except Exception as error:
            self.errors.append(error)


def test_both_draw_what_they_draw_alone_while_the_other_one_works(tmp_path):
    if addon_utils.enable("cycles") is None:
        pytest.skip("this Blender has no Cycles")
    box_scene()
    alone = style_picture.draw(style.load("watercolor"))
    rendered = cycles_picture(tmp_path / "alone.png")
    drawing = Drawing()
    beside = cycles_picture(tmp_path / "beside.png", drawing)
    assert drawing.errors == [] and len(drawing.pictures) >= AT_ONCE
    assert all(np.array_equal(picture, alone) for picture in drawing.pictures)
    assert rendered.std() > 0.01 and np.array_equal(beside, rendered)
