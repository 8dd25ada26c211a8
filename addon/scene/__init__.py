# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender's scene holds for a drawing: surfaces, materials, colors, cameras, and what objects say of their lines.
Read from an evaluated depsgraph; `api` gives it to scripts."""
