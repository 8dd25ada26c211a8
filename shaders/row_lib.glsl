// SPDX-License-Identifier: GPL-3.0-or-later
// Fetches an entry of a table, stored as one long row wrapped over texture rows of ROW_WIDTH texels.
vec4 fetch_row(sampler2D table, int index)
{
  return texelFetch(table, ivec2(index % ROW_WIDTH, index / ROW_WIDTH), 0);
}
