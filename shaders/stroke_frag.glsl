void main()
{
  int entry = 3 * int(pen_number);
  vec4 color = fetch_row(pens, entry);
  vec4 style = fetch_row(pens, entry + 1);
  ivec2 size = ivec2(fetch_row(pens, entry + 2).xy);
  float alpha = stroke_coverage(place.x, place.y, ends.x, ends.y, half_width, style.y > 0.5);
  if (size.x > 0) {
    alpha *= stroke_ink(int(style.z), size, place.x, place.y, half_width, style.x);
  }
  alpha *= opacity * color.w;
#ifdef SPINE
  if (alpha > 0.0) {
    alpha *= spine_visibility(clamp(place.x, ends.x, ends.y));
  }
#endif
  line_color = vec4(color.xyz * alpha, alpha);
}
