// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of the item buffer: per segment a quad of four vertices, one texel wide across its major axis, so that it
// covers one texel per column (or row). Clip-space z is depth (native/fovea/base/view.h); unoccluded lines are nearest.
void main()
{
  int segment = int(corner) / 4;
  vec4 first = fetch_row(segments, 3 * segment);
  vec4 last = fetch_row(segments, 3 * segment + 1);
  vec3 end = int(corner) % 4 < 2 ? first.xyz : last.xyz;
  vec2 way = abs((last.xy - first.xy) * buffer_scale);
  vec2 across = way.x >= way.y ? vec2(0.0, 0.5) : vec2(0.5, 0.0);
  vec2 texel = (end.xy + border) * buffer_scale + (int(corner) % 2 == 0 ? across : -across);
  gl_Position = vec4(texel / buffer_size * 2.0 - 1.0, clamp(end.z, 0.0, 1.0) * 2.0 - 1.0, 1.0);
  line_depth = end.z;
  item_number = fetch_row(items, segment).x;
}
