# SPDX-License-Identifier: GPL-3.0-or-later
"""What users read of the stages of a picture: in the report, in panels, and in headers while it is drawn."""

STAGES = {  # stages as the core and session.py name them -> labels
    "near_frames": "Frames Around It",
    "ingest": "Reading the Scene",
    "bvh": "Preparing Rays",
    "lines": "Finding Lines",
    "project": "Projecting Lines",
    "visibility": "What Is Hidden",
    "runs": "Joining, Tidying",
    "elision": "Line Thinning",
    "shape": "Shaping Strokes",
    "strokes": "Drawing Strokes",
    "color": "Colors under Lines",
    "focus": "Focus and Its Effects",
    "paper": "Paper",
    "depth": "Depth Pass",
    "passes": "Passes of Lines",
}


def label(stage):
    return STAGES.get(stage, stage)


def show(engine, text=""):
    """Shows a text in the header of the picture, and the engine's `note`, if it has one."""
    words = " | ".join(filter(None, (text, getattr(engine, "note", ""))))
    engine.update_stats("Fovea" if words else "", words)
