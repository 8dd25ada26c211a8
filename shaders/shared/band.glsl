// SPDX-License-Identifier: GPL-3.0-or-later
// A line's band in the priority buffer (native/fovea/elision/bands.h). Also compiled as C++, as members of a struct.
//   across  pixels across the line, positive to its left; half the band's width; how near the run's end is, from 0 to
//           1 there, negative towards its start

float band_coverage(vec3 across)
{
  return clamp(across.y + 0.5f - abs(across.x), 0.0f, 1.0f);
}

// Signed length of the vector from the line's center towards the pixel, positive to the left: 1, falling to .5 towards
// the ends of the band.
float band_side(vec3 across)
{
  float size = 1.0f - 0.5f * min(1.0f, abs(across.z));
  return across.x < 0.0f ? -size : size;
}

// Whether the nearer end of the band lies to the right of that vector.
bool band_ends_right(vec3 across)
{
  return (across.z > 0.0f) == (across.x >= 0.0f);
}

// Whether two lines cross at more than 45 degrees, from vectors of any length across them.
bool bands_cross(vec2 a, vec2 b)
{
  float c = dot(a, b);
  return 2.0f * c * c < dot(a, a) * dot(b, b);
}
