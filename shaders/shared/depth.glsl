// SPDX-License-Identifier: GPL-3.0-or-later
// Probes of the depth buffer, as specified in native/fovea/visibility/sampled.h. Also compiled as C++, as members of a
// struct. The including program provides shared/edges.glsl and
//   struct Line                             with float steepness: of its facets; -1: an inner line
//   int depth_shows(ivec2 place, Line line) what a texel shows: -1 background, 1 a facet of the line, 0 another
//   vec3 depth_plane(ivec2 place)           its depth, and its change per pixel to the right and up
//   vec2 depth_edges(ivec2 place)           edges of its triangle
//   ivec2 depth_size()                      of the buffer
//   vec2 border, float buffer_scale         its layout;  float slack_px, bias, int probes  as in SampledOptions

// A texel compared with a line at a probe.
struct Look {
  float gap;    // depth by which its surface lies in front of the line
  float bulge;  // a gap up to this may come from the line's own surface
  bool own;     // it shows a facet of the line
  bool holds;   // its surface lies in front, and its triangle extends to the probe
};

// `at`: the probe in texels; `depth`: depth of the line at the probe.
Look depth_look(vec2 texel, Line line, vec2 at, float depth)
{
  ivec2 place = clamp(ivec2(texel), ivec2(0), depth_size() - 1);
  int shows = depth_shows(place, line);
  if (shows != 0) {
    return Look(0.0f, 0.0f, shows > 0, false);
  }
  vec2 off = at - (vec2(place) + 0.5f);
  vec2 away = off / buffer_scale;
  vec3 plane = depth_plane(place);
  vec2 slope = vec2(plane.y, plane.z);
  float surface = plane.x + dot(slope, away);
  float slack = slack_px * (abs(slope.x) + abs(slope.y)) + bias * plane.x;
  float gap = surface - slack - depth;
  float bulge = max(length(slope), line.steepness) * length(away);
  return Look(gap, bulge, false, gap > 0.0f && packed_edges_hold(depth_edges(place), off));
}

bool depth_sees(Line line, vec2 px, float depth)
{
  vec2 at = (px + border) * buffer_scale;
  vec2 nearest = floor(at), opposite = 2.0f * floor(at - 0.5f) + 1.0f - nearest;  // of the four around `at`
  bool inner = line.steepness < 0.0f;
  bool open = false;
  for (int k = 0; k < 4; k++) {
    vec2 texel = vec2(k % 2 == 0 ? nearest.x : opposite.x, k < 2 ? nearest.y : opposite.y);
    Look there = depth_look(texel, line, at, depth);
    bool clearly = k == 0 && there.gap > (inner ? 0.0f : there.bulge);
    if (there.holds || clearly) {
      return false;
    }
    open = open || (inner ? there.own : there.gap <= 0.0f);
  }
  return open;
}

bool depth_probe(Line line, vec3 first, vec3 last, float t0, float t1, int k)
{
  vec3 place = mix(first, last, mix(t0, t1, (float(k) + 0.5f) / float(probes)));
  return depth_sees(line, vec2(place.x, place.y), place.z);
}

// Visibility: share of the probes that are not hidden, spread evenly over the line between screen fractions t0 and t1.
float depth_share(Line line, vec3 first, vec3 last, float t0, float t1)
{
  bool start = depth_probe(line, first, last, t0, t1, 0);
  if (probes == 1 || start == depth_probe(line, first, last, t0, t1, probes - 1)) {
    return start ? 1.0f : 0.0f;
  }
  int seen = 0;
  for (int k = 0; k < probes; k++) {
    seen += depth_probe(line, first, last, t0, t1, k) ? 1 : 0;
  }
  return float(seen) / float(probes);
}
