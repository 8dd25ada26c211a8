// SPDX-License-Identifier: GPL-3.0-or-later
// Shading of one fragment of a stroke. Also compiled as C++, as members of a struct, through GLM
// (native/fovea/stroke/fragment.h). The including program provides
//   float ink_texel(int index)                            of a texture, row after row
//   float octave_value(int first, ivec2 size, int index)  what two octaves of the texture are made one by, whose first
//                                                         texel is number `first` (native/fovea/stroke/octaves.h)

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

// Texture coordinate along the stroke [texels], -0.5 to columns - 0.5, of a place in repetitions.
float ink_across(ivec2 size, float along)
{
  return (along - floor(along)) * float(size.x) - 0.5f;
}

// The column of a repeated texture; -1 is before the first one.
int ink_column(ivec2 size, int column)
{
  return column < 0 ? size.x - 1 : (column < size.x ? column : 0);
}

// Ink in [0, 1], bilinear: repeated along the stroke (`along`: in repetitions), clamped at the sides. The texture must
// be fitted to the pen (stroke/ink.h), so that no texel is much smaller than a pixel.
float stroke_ink(int first, ivec2 size, float along, float v, float half_width_px)
{
  float x = ink_across(size, along);
  float y = ink_height(size, v, half_width_px);
  int x0 = int(floor(x));
  int y0 = int(y);
  int left = ink_column(size, x0);
  int right = ink_column(size, x0 + 1);
  int upper = first + y0 * size.x;
  int lower = y0 + 1 < size.y ? upper + size.x : upper;
  float fx = x - float(x0);
  float a = blend(ink_texel(upper + left), ink_texel(upper + right), fx);
  float b = blend(ink_texel(lower + left), ink_texel(lower + right), fx);
  return blend(a, b, y - float(y0));
}

// Mean along the stroke of the ink that stroke_ink gives at this v, of a texture of grain.
float mean_stroke_ink(int first, ivec2 size, float v, float half_width_px)
{
  float y = ink_height(size, v, half_width_px);
  int y0 = int(y);
  return blend(octave_value(first, size, y0), octave_value(first, size, min(y0 + 1, size.y - 1)), y - float(y0));
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

// Steps between the shares of the finer octave for which rows of dashes have shifts.
int octave_steps()
{
  return 16;
}

// Place in the dashes of an octave of the middle of a path that has so many repetitions of it. Gaps of an octave are gaps
// of the next finer one, so that dashes divide in their middles, and the middle of a path is far from them in all, so
// that short paths stay visible: it is a third of a repetition off to one side, then to the other.
float dash_phase(float repeats)
{
  float octave = floor(log2(repeats) + 0.5f);
  return octave - 2.0f * floor(0.5f * octave) < 0.5f ? 11.0f / 6.0f : 7.0f / 6.0f;
}

float texel_rank(int first, ivec2 size, float along, int row)
{
  float x = ink_across(size, along);
  int x0 = int(floor(x));
  float left = octave_value(first, size, row * size.x + ink_column(size, x0));
  float right = octave_value(first, size, row * size.x + ink_column(size, x0 + 1));
  return blend(left, right, x - float(x0));
}

// Rank in a row of dashes of what two octaves make together, of which the finer one has this share; `along`: in its
// repetitions. What a share p of the texture has, a share (1 - finer) p of the coarser octave still has and a share
// finer * p of the finer one has already. Where these have nothing to do with each other all ranks are as frequent.
float octave_rank(int first, ivec2 size, float along, float finer, int row)
{
  float coarse = texel_rank(first, size, 0.5f * along + 0.25f, row) / max(1.0f - finer, 1e-6f);
  float fine = texel_rank(first, size, along, row) / max(finer, 1e-6f);
  float share = min(coarse, fine);
  return 1.0f - (1.0f - min((1.0f - finer) * share, 1.0f)) * (1.0f - min(finer * share, 1.0f));
}

// Ink of this rank in a row.
float ranked_ink(int first, ivec2 size, float rank, int row)
{
  float x = clamp(rank * float(size.x) - 0.5f, 0.0f, float(size.x - 1));
  int x0 = int(x);
  int lower = (size.y + row) * size.x + x0;
  return blend(octave_value(first, size, lower), octave_value(first, size, x0 + 1 < size.x ? lower + 1 : lower), x - float(x0));
}

// What is added to the ranks of a row.
float rank_shift(int first, ivec2 size, float finer, int row)
{
  float x = finer * float(octave_steps());
  int x0 = min(int(x), octave_steps() - 1);
  int lower = 2 * size.x * size.y + row * (octave_steps() + 1) + x0;
  return blend(octave_value(first, size, lower), octave_value(first, size, lower + 1), x - float(x0));
}

float dash_row_ink(int first, ivec2 size, float along, float finer, int row)
{
  float rank = octave_rank(first, size, along, finer, row) + rank_shift(first, size, finer, row);
  return ranked_ink(first, size, rank, row);
}

// Ink of dashes that divide; `along`: in repetitions of the finer octave, which has this share, from dash_phase on. Gaps
// of the coarser one narrow in the middle half of an octave while others of the finer one open, so that as much is ink.
float dividing_dash_ink(int first, ivec2 size, float along, float v, float half_width_px, float finer)
{
  float opened = clamp(2.0f * finer - 0.5f, 0.0f, 1.0f);
  float y = ink_height(size, v, half_width_px);
  int y0 = int(y);
  float a = dash_row_ink(first, size, along, opened, y0);
  float b = dash_row_ink(first, size, along, opened, min(y0 + 1, size.y - 1));
  return blend(a, b, y - float(y0));
}

// Ink of grain that divides. Both octaves are mixed, and the contrast along the line that this loses is restored about
// the mean of the row, so that darkness and roughness are constant in a zoom; the profile across the line is unchanged.
float dividing_grain_ink(int first, ivec2 size, float along, float v, float half_width_px, float finer)
{
  float fine = stroke_ink(first, size, along, v, half_width_px);
  float coarse = stroke_ink(first, size, 0.5f * along, v, half_width_px);
  float mean = mean_stroke_ink(first, size, v, half_width_px);
  float kept = sqrt(finer * finer + (1.0f - finer) * (1.0f - finer));
  return clamp(mean + (blend(coarse, fine, finer) - mean) / kept, 0.0f, 1.0f);
}

// Ink of a texture anchored to a path, at this place on it, where all of it would have path_px pixels.
float anchored_stroke_ink(int first, ivec2 size, bool dashed, float place, float v, float half_width_px, float path_px, float texture_length_px)
{
  vec2 octave = stroke_octave(path_px, texture_length_px);
  float along = place * octave.x;
  if (dashed) {
    return dividing_dash_ink(first, size, along + dash_phase(octave.x), v, half_width_px, octave.y);
  }
  return dividing_grain_ink(first, size, along, v, half_width_px, octave.y);
}
