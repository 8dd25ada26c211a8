// SPDX-License-Identifier: GPL-3.0-or-later
// Looking into the depth buffer: the arithmetic, and the reasons, of native/fovea/visibility/sampled.cpp and .h. Change both.

struct Line {
  vec2 facets;
  float steepness;  // -1: an inner line
};

struct Look {
  float gap;    // how far the texel's surface lies in front of the line
  float bulge;  // a gap up to this may come from the line's own surface
  bool own;     // shows a facet of the line
  bool holds;   // its surface lies in front, and its triangle reaches as far as the probe
};

// True where `off` texels from the centre lie inside the edge (native/fovea/visibility/triangle_edges.h).
bool edge_holds(int code, vec2 off)
{
  float turn = float(code / 256) / 64.0;
  float x = abs(turn - 2.0) - 1.0;
  float y = turn < 2.0 ? 1.0 - abs(turn - 1.0) : abs(turn - 3.0) - 1.0;
  return float(code % 256) / 255.0 + x * off.x + y * off.y >= 0.0;
}

bool edges_hold(ivec2 place, vec2 off)
{
  ivec2 packed_edges = ivec2(texelFetch(edge_buffer, place, 0).xy);
  ivec2 whole = packed_edges / 256, rest = packed_edges % 256;
  return edge_holds(whole.x, off) && edge_holds(whole.y, off) && edge_holds(rest.x * 256 + rest.y, off);
}

// `at`: the probe in texels; `depth`: of the line there.
Look depth_look(vec2 texel, Line line, vec2 at, float depth)
{
  ivec2 place = clamp(ivec2(texel), ivec2(0), textureSize(depth_buffer, 0) - 1);
  vec4 here = texelFetch(depth_buffer, place, 0);
  bool own = here.w >= 0.0 && (here.w == line.facets.x || here.w == line.facets.y);
  if (own || here.w < 0.0) {
    return Look(0.0, 0.0, own, false);
  }
  vec2 off = at - (vec2(place) + 0.5);
  vec2 away = off / buffer_scale;
  float surface = here.x + dot(here.yz, away);
  float slack = slack_px * (abs(here.y) + abs(here.z)) + bias * here.x;
  float gap = surface - slack - depth;
  float bulge = max(length(here.yz), line.steepness) * length(away);
  return Look(gap, bulge, false, gap > 0.0 && edges_hold(place, off));
}

bool depth_sees(Line line, vec2 px, float depth)
{
  vec2 at = (px + border) * buffer_scale;
  vec2 nearest = floor(at), opposite = 2.0 * floor(at - 0.5) + 1.0 - nearest;
  bool inner = line.steepness < 0.0;
  bool open = false;
  for (int k = 0; k < 4; k++) {
    vec2 texel = vec2(k % 2 == 0 ? nearest.x : opposite.x, k < 2 ? nearest.y : opposite.y);
    Look there = depth_look(texel, line, at, depth);
    bool clearly = k == 0 && there.gap > (inner ? 0.0 : there.bulge);
    if (there.holds || clearly) {
      return false;
    }
    open = open || (inner ? there.own : there.gap <= 0.0);
  }
  return open;
}

bool depth_probe(Line line, vec3 first, vec3 last, float t0, float t1, int k)
{
  vec3 place = mix(first, last, mix(t0, t1, (float(k) + 0.5) / float(probes)));
  return depth_sees(line, place.xy, place.z);
}

// Share of the probes, evenly spread over the part of the line between two fractions of its way, that see it.
float depth_share(Line line, vec3 first, vec3 last, float t0, float t1)
{
  bool start = depth_probe(line, first, last, t0, t1, 0);
  if (probes == 1 || start == depth_probe(line, first, last, t0, t1, probes - 1)) {
    return start ? 1.0 : 0.0;
  }
  int seen = 0;
  for (int k = 0; k < probes; k++) {
    seen += depth_probe(line, first, last, t0, t1, k) ? 1 : 0;
  }
  return float(seen) / float(probes);
}
