# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads from an evaluated depsgraph what a drawing needs: surfaces, materials, colors, cameras, per-object overrides.
`api` is the interface for scripts."""
