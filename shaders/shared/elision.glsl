// SPDX-License-Identifier: GPL-3.0-or-later
// The elision test: what a line's own band loses to others, as specified in native/fovea/elision/elide.h. Also compiled
// as C++, as members of a struct.
//   place   pixel position and direction of a sample of the line
//   band    half width [px], rank, pixels back to its run's start and ahead to its end
//   figure  number of the run's figure (-1: none); how far it is small enough to be thinned as a whole, in [0, 1]; length
//           of the run, or of the figure [px]
//   across  vector across another line, from its center towards the pixel; its length is 1, falling to .5 towards
//           the ends of that line's band

// Weight in [0, 1] of short runs: 1 up to half the band's width, falling to 0 at three times that length.
float elision_shortness(vec4 band, vec3 figure)
{
  return 1.0f - smoothstep(band.x, 3.0f * band.x, figure.z);
}

// Weight in [0, 1] of a line of the figure `other`: 0 if it is of the line's own, as far as that is small.
float elision_foreign(vec3 figure, float other)
{
  return figure.x >= 0.0f && figure.x == other ? 1.0f - figure.y : 1.0f;
}

// Weight in [0, 1] with which another line can meet this one at an end `distance_px` away; it falls to 0 at so many
// half widths of the band.
float elision_near_end(vec4 band, float distance_px, float half_widths)
{
  return 1.0f - smoothstep(0.5f * half_widths * band.x, half_widths * band.x, distance_px);
}

// `near` times the bilinear weight of pixel k of the four around an end, `off` pixels from the first of them:
// continuous when the end moves.
float elision_corner(float near, vec2 off, int k)
{
  return near * (k % 2 == 0 ? 1.0f - off.x : off.x) * (k / 2 == 0 ? 1.0f - off.y : off.y);
}

// Sample position k of `rows` in column j of `columns` of the window.
vec2 elision_place(vec4 place, vec4 band, int j, int columns, int k, int rows, float window_px)
{
  float shift = (float(j) + 0.5f) / float(columns);  // positions are staggered between columns
  vec2 column = vec2(place.x, place.y) + vec2(place.z, place.w) * ((shift - 0.5f) * window_px);
  return column + vec2(-place.w, place.z) * (((float(k) + shift) / float(rows) - 0.5f) * (2.0f * band.x + 1.0f));
}

int elision_rows(vec4 band, int most)
{
  return min(most, int(ceil(2.0f * (2.0f * band.x + 1.0f))));
}

// Coverage of a pixel u px along the line by the interval between the run's ends.
float elision_inside(vec4 band, float u)
{
  return clamp(u + band.z + 0.5f, 0.0f, 1.0f) * clamp(band.w - u + 0.5f, 0.0f, 1.0f);
}

// Coverage of a pixel v px across the line by the line's band.
float elision_own(vec4 band, float v)
{
  return clamp(band.x + 0.5f - abs(v), 0.0f, 1.0f);
}

// Weight in [0, 1] with which the line takes over from another one that ends: 1 over the last two thirds of the reach
// before that end, if the line continues as far beyond it. `size`: length of `across`; `right`: the other
// line's nearer end lies to the right of `across`.
float elision_takes_over(vec4 place, vec4 band, float u, vec2 across, float size, bool right, float reach_px)
{
  float near_end = 2.0f * (1.0f - size);
  if (near_end <= 0.0f) {
    return 0.0f;
  }
  float ahead = (place.z * (across.y / size) - place.w * (across.x / size)) * (right ? 1.0f : -1.0f);
  float beyond = (ahead > 0.0f ? band.w - u : band.z + u) - (1.0f - near_end) * reach_px;
  return min(1.0f, 3.0f * near_end) * smoothstep(0.0f, reach_px, beyond);
}

// The part of a pixel lost to another line, whose band covers `covered` of it. `own`: coverage by the line's own band;
// `away`: unit vector across the line, towards the pixel; `met`: how far one of the run's ends lies in the other's
// band. The loss rises from 60 to 30 degrees between the two, and from 25 to 10 where they meet.
float elision_lost(vec4 place, vec4 band, float own, float u, vec2 away, vec2 across, bool right, float covered, float met, float shortness, float reach_px)
{
  float size = length(across), cosine = dot(away, across) / size;
  float weight = mix(smoothstep(0.25f, 0.75f, cosine * cosine), smoothstep(0.8214f, 0.9698f, cosine * cosine), met) *
                 (1.0f - elision_takes_over(place, band, u, across, size, right, reach_px));
  // Overlap of the two coverages: between the lines they cover the pixel from opposite sides, else from the same.
  float both = cosine < 0.0f ? max(0.0f, own + covered - 1.0f) : min(own, covered);
  return max(weight, shortness) * both;
}
