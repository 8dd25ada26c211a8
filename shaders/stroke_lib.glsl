// SPDX-License-Identifier: GPL-3.0-or-later
// What one fragment of a stroke adds to the picture. This file repeats native/fovea/stroke/fragment.h: change both.

// Share of the pixel that the stroke covers. All in px: u along the path, v across, u of the run's start and end, half
// the drawn width. The edge is a ramp one pixel wide, centred on the true edge.
float stroke_coverage(float u, float v, float start, float end, float half_width_px, bool round_cap)
{
  if (round_cap) {
    float beyond = max(max(start - u, u - end), 0.0);
    float away = beyond > 0.0 ? sqrt(beyond * beyond + v * v) : abs(v);
    return clamp(half_width_px - away + 0.5, 0.0, 1.0);
  }
  float side = clamp(half_width_px - abs(v) + 0.5, 0.0, 1.0);
  float along = clamp(u - start + 0.5, 0.0, 1.0) + clamp(end - u + 0.5, 0.0, 1.0) - 1.0;
  return side * max(along, 0.0);
}

// Ink, bilinear: repeated along the stroke (`along`: in repetitions), held at the sides. `ink`: row after row from
// entry `first` on, then the mean of each row.
float stroke_ink(int first, ivec2 size, float along, float v, float half_width_px)
{
  float x = (along - floor(along)) * float(size.x) - 0.5;
  float y = clamp((half_width_px - v) / (2.0 * half_width_px) * float(size.y) - 0.5, 0.0, float(size.y - 1));
  int x0 = int(floor(x));
  int y0 = int(y);
  int left = x0 < 0 ? size.x - 1 : x0;
  int right = x0 + 1 < size.x ? x0 + 1 : 0;
  int upper = first + y0 * size.x;
  int lower = y0 + 1 < size.y ? upper + size.x : upper;
  float fx = x - float(x0);
  float a = mix(fetch_row(ink, upper + left).x, fetch_row(ink, upper + right).x, fx);
  float b = mix(fetch_row(ink, lower + left).x, fetch_row(ink, lower + right).x, fx);
  return mix(a, b, y - float(y0));
}

// Mean along the stroke of the ink that stroke_ink gives at this v.
float mean_ink(int first, ivec2 size, float v, float half_width_px)
{
  float y = clamp((half_width_px - v) / (2.0 * half_width_px) * float(size.y) - 0.5, 0.0, float(size.y - 1));
  int y0 = int(y);
  int means = first + size.x * size.y;
  float a = fetch_row(ink, means + y0).x;
  float b = fetch_row(ink, means + min(y0 + 1, size.y - 1)).x;
  return mix(a, b, y - float(y0));
}

// Ink of a texture anchored to its path: two octaves of it, whose repetitions along the whole path are powers of two.
float anchored_ink(int first, ivec2 size, float u, float v, float half_width_px, float path_px, float texture_length_px)
{
  float level = max(path_px, 1.0) / texture_length_px;
  float repeats = exp2(ceil(log2(level)));
  float finer = clamp(2.0 * level / repeats - 1.0, 0.0, 1.0);
  float along = u / max(path_px, 1.0) * repeats;
  float fine = stroke_ink(first, size, along, v, half_width_px);
  float coarse = stroke_ink(first, size, 0.5 * along, v, half_width_px);
  float mean = mean_ink(first, size, v, half_width_px);
  float kept = sqrt(finer * finer + (1.0 - finer) * (1.0 - finer));
  return clamp(mean + (mix(coarse, fine, finer) - mean) / kept, 0.0, 1.0);
}
