// SPDX-License-Identifier: GPL-3.0-or-later
// Ink of a pen at this fragment.
float ink_of(int pen_index)
{
  vec4 style = fetch_row(pens, 4 * pen_index + 1);
  vec4 texture_of = fetch_row(pens, 4 * pen_index + 2);
  ivec2 size = ivec2(texture_of.xy);
  if (size.x == 0) {
    return 1.0;
  }
  if (style.w > 0.5) {
    return anchored_stroke_ink(int(style.z), size, texture_of.z > 0.5, anchored.x, arc_place.y, half_width, anchored.y, style.x);
  }
  return stroke_ink(int(style.z), size, arc_place.x / style.x, arc_place.y, half_width);
}

void main()
{
  int pen_index = int(pen_number);
  vec4 color = fetch_row(pens, 4 * pen_index);
  bool round_cap = fetch_row(pens, 4 * pen_index + 1).y > 0.5;
  float alpha = opacity * stroke_coverage(arc_place.x, arc_place.y, ends.x, ends.y, half_width, round_cap);
  float ink_here = ink_of(pen_index);
  int other = int(color.w);
  if (other != pen_index) {
    color = mix(color, fetch_row(pens, 4 * other), mixed.x);
    ink_here = mix(ink_here, ink_of(other), mixed.y);
  }
#ifdef PAINTED
  color.xyz = own_color;
#endif
  if (mixed.z > 0.0) {
    vec4 second = mix(fetch_row(pens, 4 * pen_index + 3), fetch_row(pens, 4 * other + 3), mixed.x);
    color = mix(color, second, mixed.z);
  }
  alpha *= stroke_ink_left(ink_here, mixed.w);
#ifdef SPINE
  if (alpha > 0.0) {
    alpha *= spine_visibility(clamp(arc_place.x, ends.x, ends.y));
  }
#endif
  line_color = vec4(color.xyz * alpha, alpha);
}
