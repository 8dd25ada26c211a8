# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of Blender's scenes: the render engine, viewports, backends, and what operators make of drawn lines.
`session` is what renders and viewports share."""
