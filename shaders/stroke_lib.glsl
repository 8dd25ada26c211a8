// SPDX-License-Identifier: GPL-3.0-or-later
// Ink of all pens, as required by shared/stroke.glsl: each texture row by row, then what two of its octaves are made one by.
float ink_texel(int index)
{
  return fetch_row(ink, index).x;
}

float octave_value(int first, ivec2 size, int index)
{
  return ink_texel(first + size.x * size.y + index);
}
