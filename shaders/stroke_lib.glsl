// SPDX-License-Identifier: GPL-3.0-or-later
// Ink of all pens, as required by shared/stroke.glsl: each texture row by row, then the mean of each row.
float ink_texel(int index)
{
  return fetch_row(ink, index).x;
}

float ink_row(int first, ivec2 size, int row)
{
  return ink_texel(first + size.x * size.y + row);
}
