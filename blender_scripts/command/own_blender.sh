# An own Blender: checked, then used in place.
