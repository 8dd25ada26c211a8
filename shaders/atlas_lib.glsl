// SPDX-License-Identifier: GPL-3.0-or-later
// The segment atlas (native/fovea/visibility/layout.h): one row of samples, wrapped over rows of the target. `owners`
// holds the segment of every OWNER_STRIDE-th sample.

// Index of this fragment's sample in the row.
int atlas_index()
{
  return int(gl_FragCoord.y) * ROW_WIDTH + int(gl_FragCoord.x);
}

// Segment that owns a sample: the last one that begins at or before it.
int atlas_owner(int index)
{
  int low = int(fetch_row(owners, index / OWNER_STRIDE).x);
  int high = int(fetch_row(owners, index / OWNER_STRIDE + 1).x);
  return last_segment(segments, low, high, float(index));
}

// The sample at this fragment.
struct AtlasSample {
  vec4 first;  // start of its segment: x, y, depth, number of its first sample
  vec4 last;   // end of its segment: x, y, depth, number of its samples
  int owner;   // the segment
  float j;     // number of the sample within the segment
};

// Whether a position lies in the core of the depth tile (left, lower, right, upper bound in px).
bool atlas_in_tile(vec2 px)
{
  return all(greaterThanEqual(px, tile.xy)) && all(lessThan(px, tile.zw));
}

// Reads the sample of an index below sample_total; discards samples outside of the tile's core, whose values are kept.
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
