# SPDX-License-Identifier: GPL-3.0-or-later
"""Gauge studies: people turn discs on a picture until they seem to lie on the surface, which tells the shape that they
see (Cole 2009, chapter 4). Without Blender.

Normals are (n, 3) unit vectors, x to the right, y up, z towards the viewer. Places are pixels from the upper left."""
