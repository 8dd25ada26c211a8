// Looking into the depth buffer: the arithmetic, and the reasons, of native/atlas/sampled.cpp and .h. Change both.

struct Line {
  vec2 facets;
  float steepness;  // -1: an inner line
};

struct Look {
  float gap;    // how far the texel's surface lies in front of the line; hides it when above 0
  float bulge;  // a gap up to this may come from the line's own surface
  bool own;     // shows a facet of the line
};

// `at`: the probe in texels; `depth`: of the line there.
Look depth_look(vec2 texel, Line line, vec2 at, float depth)
{
  ivec2 place = clamp(ivec2(texel), ivec2(0), textureSize(depth_buffer, 0) - 1);
  vec4 here = texelFetch(depth_buffer, place, 0);
  bool own = here.w >= 0.0 && (here.w == line.facets.x || here.w == line.facets.y);
  if (own || here.w < 0.0) {
    return Look(0.0, 0.0, own);
  }
  vec2 away = (at - (vec2(place) + 0.5)) / buffer_scale;
  float surface = here.x + dot(here.yz, away);
  float slack = slack_px * (abs(here.y) + abs(here.z)) + bias * here.x;
  return Look(surface - slack - depth, max(length(here.yz), line.steepness) * length(away), false);
}

bool depth_sees(Line line, vec2 px, float depth)
{
  vec2 at = (px + border) * buffer_scale;
  bool inner = line.steepness < 0.0;
  Look nearest = depth_look(floor(at), line, at, depth);
  if (nearest.gap > (inner ? 0.0 : nearest.bulge)) {
    return false;
  }
  vec2 corner = floor(at - 0.5);
  for (int k = 0; k < 4; k++) {
    Look around = depth_look(corner + vec2(k % 2, k / 2), line, at, depth);
    if (inner ? around.own : around.gap <= 0.0) {
      return true;
    }
  }
  return false;
}

// Share of the probes, evenly spread over the part of the line between two fractions of its way, that see it.
float depth_share(Line line, vec3 first, vec3 last, float t0, float t1)
{
  int seen = 0;
  for (int k = 0; k < probes; k++) {
    vec3 place = mix(first, last, mix(t0, t1, (float(k) + 0.5) / float(probes)));
    seen += depth_sees(line, place.xy, place.z) ? 1 : 0;
  }
  return float(seen) / float(probes);
}
