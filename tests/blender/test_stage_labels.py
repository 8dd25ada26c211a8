# SPDX-License-Identifier: GPL-3.0-or-later
"""Stages have the same names for users wherever they read them."""

from types import SimpleNamespace

import bpy
from pictures import box_scene
from the_addon import part

session, viewport, report = part("render.session"), part("render.viewport"), part("render.report")
IDS_AND_LABELS = {"elision": "Line Thinning", "bvh": "Preparing Rays", "near_frames": "Frames Around It"}


class Header:
    """Keeps what an engine is told to say."""

    def __init__(self):
        self.said = []

    def update_stats(self, title, text):
        self.said.append(text)

    def update_progress(self, share):
        pass

    def tag_redraw(self):
        pass


def test_the_header_of_a_render_has_labels_of_stages():
    header = Header()
    for stage in IDS_AND_LABELS:
        session._progress(header, 0.5, stage)
    assert header.said == list(IDS_AND_LABELS.values())


def test_the_header_of_a_render_has_a_label_for_every_stage_of_a_picture(monkeypatch):
    said = []
    monkeypatch.setattr(session, "_progress", lambda _engine, _share, text: said.append(text))
    box_scene()
    bpy.ops.render.render()
    assert "visibility" in said and set(said) <= part("render.stage_labels").STAGES.keys()


def test_the_header_of_a_viewport_has_labels_of_stages():
    header = Header()
    for stage in IDS_AND_LABELS:
        job = SimpleNamespace(started=float("-inf"), told=(0.25, stage))
        viewport.Viewport().tell(header, job)
    assert header.said == [f"{label} 25%" for label in IDS_AND_LABELS.values()]


def test_the_report_has_labels_of_stages():
    known = {"stages": dict.fromkeys(IDS_AND_LABELS, 1.0), "backend": "cpu", "strokes": 3, "visibility": "exact"}
    _, *lines = report.times(known)
    assert [line.rsplit(maxsplit=2)[0].strip() for line in lines] == list(IDS_AND_LABELS.values())
