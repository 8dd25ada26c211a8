// SPDX-License-Identifier: GPL-3.0-or-later
// The segment atlas (native/fovea/visibility/layout.h): one row of samples, wrapped over rows of the target. Every
// OWNER_STRIDE samples `owners` says which segment they are in.

// Place of this fragment in the row.
int atlas_index()
{
  return int(gl_FragCoord.y) * ROW_WIDTH + int(gl_FragCoord.x);
}

// Segment that owns a sample: the last one that begins no later.
int atlas_owner(int index)
{
  int low = int(fetch_row(owners, index / OWNER_STRIDE).x);
  int high = int(fetch_row(owners, index / OWNER_STRIDE + 1).x);
  while (low < high) {
    int middle = (low + high + 1) / 2;
    if (fetch_row(segments, 3 * middle).w <= float(index)) {
      low = middle;
    }
    else {
      high = middle - 1;
    }
  }
  return low;
}

// The sample at this fragment.
struct AtlasSample {
  vec4 first;  // of its segment: x, y, depth, number of its first sample
  vec4 last;   // x, y, depth, how many samples
  int owner;   // the segment
  float j;     // number of the sample on it
};

// Whether the depth tile (left, lower, right, upper edge in px) decides what lies there.
bool atlas_in_tile(vec2 px)
{
  return all(greaterThanEqual(px, tile.xy)) && all(lessThan(px, tile.zw));
}

// Of a sample below sample_total; those that the tile does not decide stay as they are.
AtlasSample atlas_sample(int index)
{
  int owner = atlas_owner(index);
  vec4 first = fetch_row(segments, 3 * owner);
  vec4 last = fetch_row(segments, 3 * owner + 1);
  float j = float(index) - first.w;
  if (!atlas_in_tile(mix(first.xy, last.xy, (j + 0.5) / last.w))) {
    discard;
  }
  return AtlasSample(first, last, owner, j);
}
