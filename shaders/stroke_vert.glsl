// SPDX-License-Identifier: GPL-3.0-or-later
// Triangle strips of strokes (native/fovea/stroke/strokes.h).
void main()
{
  gl_Position = vec4((px - image_origin) / image_size * 2.0 - 1.0, 0.0, 1.0);
  arc_place = arc.xy;
  ends = arc.zw;
  anchored = anchor;
  half_width = width_opacity.x;
  opacity = width_opacity.y;
  pen_number = float(pen);
  mixed = mixes;
#ifdef PAINTED
  own_color = painted_color;
#endif
#ifdef SPINE
  spine = spine_range;
#endif
}
