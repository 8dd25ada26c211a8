// SPDX-License-Identifier: GPL-3.0-or-later
// The elision test for the sample at this fragment, by the formulas of shared/elision.glsl.
struct Own {
  vec4 place;       // pixel position, unit direction
  vec4 band;        // half width, rank, pixels back to the run's start and ahead to its end
  vec4 at_ends[8];  // 4 pixels around the run's start, 4 around its end: (rank, weight) of both layers
  vec3 figure;      // number (-1: none), weight, length
  float shortness;  // elision_shortness of the run
};

bool in_buffer(ivec2 texel)
{
  return all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, textureSize(layer0, 0)));
}

// How far one of the run's ends (first pixel `end` of at_ends) lies in the band of the line of this rank, in [0, 1].
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

// The part of a pixel that is lost to another line.
float lost(vec4 other, Own line, float own, float u, vec2 away)
{
  if (other.x <= line.band.y) {
    return 0.0;
  }
  float met = max(meets(line, other.x, 0), meets(line, other.x, 4));
  return elision_foreign(line.figure, fetch_row(figure_of_rank, int(other.x)).x) *
         elision_lost(line.place, line.band, own, u, away, other.zw, other.y < 0.0, abs(other.y), met, line.shortness, reach);
}

// (lost, own) share of the pixel that contains a sample position of the window.
vec2 window_pixel(vec2 at, Own line)
{
  ivec2 pixel = ivec2(floor(at)), texel = pixel - ivec2(buffer_origin);
  if (!in_buffer(texel)) {
    return vec2(0.0);
  }
  vec2 from = vec2(pixel) + 0.5 - line.place.xy, left = vec2(-line.place.w, line.place.z);
  float u = dot(from, line.place.zw), v = dot(from, left);
  float own = elision_own(line.band, v);
  vec2 away = v < 0.0 ? -left : left;
  vec4 first = unpacked_texel(texelFetch(layer0, texel, 0).xy);
  float taken = 0.0;
  if (first.x > line.band.y) {
    vec4 second = unpacked_texel(texelFetch(layer1, texel, 0).xy);
    taken = max(lost(first, line, own, u, away), lost(second, line, own, u, away));
  }
  return elision_inside(line.band, u) * vec2(taken, own);
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

// (rank, weight) of both layers at one of the four pixels around an end of the run.
vec4 at_end(vec2 end, int k, float near)
{
  if (near == 0.0) {
    return vec4(0.0);
  }
  vec2 corner = floor(end - 0.5), t = end - 0.5 - corner, ahead = vec2(k % 2, k / 2);
  float share = elision_corner(near, t, k);
  return bands_at(corner + ahead) * vec4(1.0, share, 1.0, share);
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
  vec2 near = vec2(elision_near_end(band, band.z, end_reach), elision_near_end(band, band.w, end_reach));
  Own line;
  line.place = place;
  line.band = band;
  line.figure = fetch_row(figures, index).xyz;
  line.shortness = elision_shortness(band, line.figure);
  for (int k = 0; k < 4; k++) {
    line.at_ends[k] = at_end(end.xy, k, near.x);
    line.at_ends[4 + k] = at_end(end.zw, k, near.y);
  }
  int rows = elision_rows(band, most_rows);
  for (int j = 0; j < window_columns; j++) {
    for (int k = 0; k < rows; k++) {
      crowding += window_pixel(elision_place(place, band, j, window_columns, k, rows, window_length), line);
    }
  }
}
