// SPDX-License-Identifier: GPL-3.0-or-later
// Shading of one fragment of a stroke. Also compiled as C++, as members of a struct, through GLM
// (native/fovea/stroke/fragment.h). The including program provides
//   float ink_texel(int index)                     of a texture, row after row
//   float ink_row(int first, ivec2 size, int row)  mean of a row of the texture whose first texel is number `first`

// Coverage of the pixel by the stroke, in [0, 1]. All in px: u along the path, v across, u of the run's start and end,
// half the drawn width. The edge is a ramp one pixel wide, centered on the true edge.
float stroke_coverage(float u, float v, float start, float end, float half_width_px, bool round_cap)
{
  if (round_cap) {
    float beyond = max(max(start - u, u - end), 0.0f);
    float away = beyond > 0.0f ? sqrt(beyond * beyond + v * v) : abs(v);
    return clamp(half_width_px - away + 0.5f, 0.0f, 1.0f);
  }
  float side = clamp(half_width_px - abs(v) + 0.5f, 0.0f, 1.0f);
  // Coverage up to the end minus coverage before the start: exact for runs of any length.
  float along = clamp(u - start + 0.5f, 0.0f, 1.0f) + clamp(end - u + 0.5f, 0.0f, 1.0f) - 1.0f;
  return side * max(along, 0.0f);
}

float blend(float a, float b, float share)
{
  return a + (b - a) * share;
}

// Range of ink over which it comes or goes where a stroke breaks up through its texture.
float ink_softness()
{
  return 0.1f;
}

// What is left of ink there: all above `faint`, nothing that is less by the softness.
float stroke_ink_left(float amount, float faint)
{
  return amount * clamp((amount - faint) / ink_softness() + 1.0f, 0.0f, 1.0f);
}

// Texture coordinate across the stroke [texels], clamped at its sides.
float ink_height(ivec2 size, float v, float half_width_px)
{
  return clamp((half_width_px - v) / (2.0f * half_width_px) * float(size.y) - 0.5f, 0.0f, float(size.y - 1));
}

// Ink in [0, 1], bilinear: repeated along the stroke (`along`: in repetitions), clamped at the sides. The texture must
// be fitted to the pen (stroke/ink.h), so that no texel is much smaller than a pixel.
float stroke_ink(int first, ivec2 size, float along, float v, float half_width_px)
{
  float x = (along - floor(along)) * float(size.x) - 0.5f;
  float y = ink_height(size, v, half_width_px);
  int x0 = int(floor(x));
  int y0 = int(y);
  int left = x0 < 0 ? size.x - 1 : x0;
  int right = x0 + 1 < size.x ? x0 + 1 : 0;
  int upper = first + y0 * size.x;
  int lower = y0 + 1 < size.y ? upper + size.x : upper;
  float fx = x - float(x0);
  float a = blend(ink_texel(upper + left), ink_texel(upper + right), fx);
  float b = blend(ink_texel(lower + left), ink_texel(lower + right), fx);
  return blend(a, b, y - float(y0));
}

// Mean along the stroke of the ink that stroke_ink gives at this v.
float mean_stroke_ink(int first, ivec2 size, float v, float half_width_px)
{
  float y = ink_height(size, v, half_width_px);
  int y0 = int(y);
  return blend(ink_row(first, size, y0), ink_row(first, size, min(y0 + 1, size.y - 1)), y - float(y0));
}

// For a texture anchored to its path: (repetitions along the whole path, weight) of the finer of two blended octaves;
// the coarser one has half the repetitions. Repetitions are powers of two, so that in a zoom they stay in place or
// split in two: 2^n with n = ceil(log2 lengths), for a path of so many texture lengths. At the end of an octave only
// the finer one is left, which is the coarser one of the next; in its middle, where both are as far from the wanted
// length, they weigh the same. Benard et al., "Self-Similar Line Artmaps", 2010. Paths below a pixel count as one.
vec2 stroke_octave(float path_px, float texture_length_px)
{
  float lengths = max(path_px, 1.0f) / texture_length_px;
  float repeats = exp2(ceil(log2(lengths)));
  float share = clamp(lengths / repeats, 0.5f, 1.0f);
  return vec2(repeats, (share - 0.5f) / (share - 0.5f + 0.70710678f * (1.0f - share)));
}

// Ink of a texture anchored to a path, at this place on it, where all of it would have path_px pixels. Two octaves are blended, and the
// contrast along the line that the blend loses is restored about the mean of the row, so that darkness and roughness
// are constant in a zoom; the profile across the line is unchanged.
float anchored_stroke_ink(int first, ivec2 size, float place, float v, float half_width_px, float path_px, float texture_length_px)
{
  vec2 octave = stroke_octave(path_px, texture_length_px);
  float along = place * octave.x, finer = octave.y;
  float fine = stroke_ink(first, size, along, v, half_width_px);
  float coarse = stroke_ink(first, size, 0.5f * along, v, half_width_px);
  float mean = mean_stroke_ink(first, size, v, half_width_px);
  float kept = sqrt(finer * finer + (1.0f - finer) * (1.0f - finer));
  return clamp(mean + (blend(coarse, fine, finer) - mean) / kept, 0.0f, 1.0f);
}
