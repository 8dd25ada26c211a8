// SPDX-License-Identifier: GPL-3.0-or-later
// A long row of table entries, wrapped over the rows of a texture, ROW_WIDTH wide.
vec4 fetch_row(sampler2D table, int index)
{
  return texelFetch(table, ivec2(index % ROW_WIDTH, index / ROW_WIDTH), 0);
}
