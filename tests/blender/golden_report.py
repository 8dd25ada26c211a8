# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes an HTML page that shows drawings beside their references, in a self-contained folder."""

import html
import shutil
from datetime import datetime

import bpy
import numpy as np

PAGE = """<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><title>{title}</title>
<style>
body {{ font: 15px sans-serif; margin: 2em; color: #222; background: #fff }}
td, th {{ padding: .3em .6em; text-align: left; vertical-align: top }}
td img {{ width: 480px; border: 1px solid #ccc; image-rendering: pixelated;
  background: repeating-conic-gradient(#fff 0 25%, #e8e8e8 0 50%) 0 0 / 16px 16px }}
.passed b {{ color: #080 }} .failed b {{ color: #c00 }}
</style>
<h1>{title}</h1>
<p>{summary} In the difference, red has lost half of its ink or
more and blue has gained it.</p>
<table><tr><th>Scene<th>Reference<th>New<th>Difference</tr>
{rows}
</table></html>
"""
ROW = """<tr class="{verdict}"><td>{name}<br><b>{verdict}</b><br>{measure}
<td><img src="{name}.reference.png"><td><img src="{name}.new.png"><td><img src="{name}.difference.png"></tr>"""


class Report:
    def __init__(self, folder):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        self.folder, self.page = folder, folder / "report.html"
        self._rows = []  # (passed, html); what failed is shown first

    def new(self, name):
        """Where the new picture of a scene belongs."""
        return self.folder / f"{name}.new.png"

    def add(self, name, reference, comparison, renewed=False):
        """Written after each scene, so that it is there when a later one crashes Blender."""
        shutil.copyfile(reference, self.folder / f"{name}.reference.png")
        _save(comparison.difference, self.folder / f"{name}.difference.png")
        verdict = "passed" if comparison.passed else "failed"
        measure = html.escape(str(comparison)) + (", reference renewed" if renewed else "")
        self._rows.append((comparison.passed, ROW.format(name=name, verdict=verdict, measure=measure)))
        rows = [row for _, row in sorted(self._rows, key=lambda row: row[0])]
        failed = sum(not passed for passed, _ in self._rows)
        title = f"Golden images, Blender {bpy.app.version_string}"
        summary = f"{datetime.now():%Y-%m-%d %H:%M}: {len(rows)} drawn, {failed} failed."
        self.page.write_text(PAGE.format(title=html.escape(title), summary=summary, rows="\n".join(rows)))


def _save(picture, path):
    """(H, W, 3) in display values, bottom row first, as a PNG."""
    height, width, _ = picture.shape
    image = bpy.data.images.new("Difference", width, height)
    image.pixels.foreach_set(np.dstack([picture, np.ones((height, width), np.float32)]).ravel())
    image.filepath_raw, image.file_format = str(path), "PNG"
    image.save()
    bpy.data.images.remove(image)
