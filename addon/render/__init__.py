# SPDX-License-Identifier: GPL-3.0-or-later
"""Rendering of Blender scenes: the render engine, viewports, choice of the backend, and operators that output lines.
`session` is shared by final renders and viewports."""
