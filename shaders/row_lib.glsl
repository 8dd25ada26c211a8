// SPDX-License-Identifier: GPL-3.0-or-later
// Fetches an entry of a table, stored as one long row wrapped over texture rows of ROW_WIDTH texels.
vec4 fetch_row(sampler2D table, int index)
{
  return texelFetch(table, ivec2(index % ROW_WIDTH, index / ROW_WIDTH), 0);
}

// The last segment from `low` to `high` that begins at or before `place`, or else `low` (binary search). A segment has
// three entries, the first of which ends with the place where it begins.
int last_segment(sampler2D table, int low, int high, float place)
{
  while (low < high) {
    int middle = (low + high + 1) / 2;
    if (fetch_row(table, 3 * middle).w <= place) {
      low = middle;
    }
    else {
      high = middle - 1;
    }
  }
  return low;
}
