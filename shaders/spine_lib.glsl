// SPDX-License-Identifier: GPL-3.0-or-later
// The spine test (native/fovea/visibility/spine.h): visibility of this stroke's piece around arc length u [px].
float spine_visibility(float u)
{
  int at = last_segment(segments, int(spine.x), int(spine.y), u);
  vec4 first = fetch_row(segments, 3 * at);
  vec4 last = fetch_row(segments, 3 * at + 1);
  vec4 own = fetch_row(segments, 3 * at + 2);
  vec2 part = vec2(0.0);
  if (last.w > first.w) {
    part = clamp((vec2(u - 0.5, u + 0.5) - first.w) / (last.w - first.w), 0.0, 1.0);
  }
  return depth_share(Line(own.xy, own.z), first.xyz, last.xyz, part.x, part.y);
}
