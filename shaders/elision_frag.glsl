// SPDX-License-Identifier: GPL-3.0-or-later
// The elision test for the sample at this fragment: crowding() of native/fovea/elision/elide.cpp.
struct Own {
  vec4 place;       // pixel position, direction
  vec4 band;        // half width, rank, pixels back to the run's start and ahead to its end
  vec4 at_ends[8];  // around the run's start, then its end: rank and how much that line meets it there, of both layers
  float shortness;  // how much it is a mere tick
};

bool in_buffer(ivec2 texel)
{
  return all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, textureSize(layer0, 0)));
}

// How much a line takes over from another, which ends.
float takes_over(Own line, float u, vec2 across, float size, bool right)
{
  float near_end = 2.0 * (1.0 - size);
  if (near_end <= 0.0) {
    return 0.0;
  }
  float ahead = (line.place.z * across.y - line.place.w * across.x) * (right ? 1.0 : -1.0);
  float beyond = (ahead > 0.0 ? line.band.w - u : line.band.z + u) - (1.0 - near_end) * reach;
  return min(1.0, 3.0 * near_end) * smoothstep(0.0, reach, beyond);
}

// How much one of the run's ends lies in the band of a line.
float meets(Own line, float rank, int end)
{
  float share = 0.0;
  for (int k = end; k < end + 4; k++) {
    vec4 there = line.at_ends[k];
    share += there.x == rank ? there.y : 0.0;
    share += there.z == rank ? there.w : 0.0;
  }
  return share;
}

// The part of a pixel that another line takes away.
float lost(vec4 other, Own line, float own, float u, vec2 away)
{
  if (other.x <= line.band.y) {
    return 0.0;
  }
  float size = length(other.zw), covered = abs(other.y);
  vec2 across = other.zw / size;
  float cosine = dot(away, across), squared = cosine * cosine;
  float met = max(meets(line, other.x, 0), meets(line, other.x, 4));
  float weight = mix(smoothstep(0.25, 0.75, squared), smoothstep(0.8214, 0.9698, squared), met);
  weight *= 1.0 - takes_over(line, u, across, size, other.y < 0.0);
  float both = cosine < 0.0 ? max(0.0, own + covered - 1.0) : min(own, covered);
  return max(weight, line.shortness) * both;
}

// (lost, own) share of the pixel that a place of the window is in.
vec2 window_pixel(vec2 at, Own line)
{
  ivec2 pixel = ivec2(floor(at)), texel = pixel - ivec2(buffer_origin);
  if (!in_buffer(texel)) {
    return vec2(0.0);
  }
  vec2 from = vec2(pixel) + 0.5 - line.place.xy, left = vec2(-line.place.w, line.place.z);
  float u = dot(from, line.place.zw), v = dot(from, left);
  float inside = clamp(u + line.band.z + 0.5, 0.0, 1.0) * clamp(line.band.w - u + 0.5, 0.0, 1.0);
  float own = clamp(line.band.x + 0.5 - abs(v), 0.0, 1.0);
  vec2 away = v < 0.0 ? -left : left;
  vec4 first = unpacked_texel(texelFetch(layer0, texel, 0).xy);
  float taken = 0.0;
  if (first.x > line.band.y) {
    vec4 second = unpacked_texel(texelFetch(layer1, texel, 0).xy);
    taken = max(lost(first, line, own, u, away), lost(second, line, own, u, away));
  }
  return inside * vec2(taken, own);
}

// Rank and coverage of both layers at a pixel.
vec4 bands_at(vec2 pixel)
{
  ivec2 texel = ivec2(pixel - buffer_origin);
  if (!in_buffer(texel)) {
    return vec4(0.0);
  }
  return vec4(owner_of(texelFetch(layer0, texel, 0).xy), owner_of(texelFetch(layer1, texel, 0).xy));
}

// One of the four pixels around an end of the run.
vec4 at_end(vec2 end, int k, float near)
{
  if (near == 0.0) {
    return vec4(0.0);
  }
  vec2 corner = floor(end - 0.5), t = end - 0.5 - corner, ahead = vec2(k % 2, k / 2);
  vec2 weight = mix(1.0 - t, t, ahead);
  vec4 found = bands_at(corner + ahead);
  return found * vec4(1.0, near * weight.x * weight.y, 1.0, near * weight.x * weight.y);
}

void main()
{
  int index = int(gl_FragCoord.y) * ROW_WIDTH + int(gl_FragCoord.x);
  crowding = vec2(0.0);
  if (index >= sample_total) {
    return;
  }
  vec4 place = fetch_row(places, index), band = fetch_row(bands, index), end = fetch_row(ends, index);
  if (any(lessThan(place.xy, tile.xy)) || any(greaterThanEqual(place.xy, tile.zw))) {
    discard;
  }
  float shortness = 1.0 - smoothstep(band.x, 3.0 * band.x, band.z + band.w);
  vec2 near = 1.0 - smoothstep(vec2(0.5 * end_reach * band.x), vec2(end_reach * band.x), band.zw);
  Own line;
  line.place = place;
  line.band = band;
  line.shortness = shortness;
  for (int k = 0; k < 4; k++) {
    line.at_ends[k] = at_end(end.xy, k, near.x);
    line.at_ends[4 + k] = at_end(end.zw, k, near.y);
  }
  float width = 2.0 * band.x + 1.0;
  int rows = min(most_rows, int(ceil(2.0 * width)));
  vec2 left = vec2(-place.w, place.z);
  for (int j = 0; j < columns; j++) {
    float shift = (float(j) + 0.5) / float(columns);
    vec2 column = place.xy + place.zw * ((shift - 0.5) * window_length);
    for (int k = 0; k < rows; k++) {
      crowding += window_pixel(column + left * (((float(k) + shift) / float(rows) - 0.5) * width), line);
    }
  }
}
