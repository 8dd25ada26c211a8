# SPDX-License-Identifier: GPL-3.0-or-later
"""Where one shall look: the places as properties of a scene, and the tools that pick, move and key them.
What a style makes of focus is the style's."""
