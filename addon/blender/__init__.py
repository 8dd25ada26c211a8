"""Everything that knows Blender."""
