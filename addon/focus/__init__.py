# SPDX-License-Identifier: GPL-3.0-or-later
"""Focus: its points as properties of a scene, and the tools that pick, move and keyframe them.
The effects of focus are part of the style."""
