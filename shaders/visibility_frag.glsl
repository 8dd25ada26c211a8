// Visibility of the atlas sample at this fragment: the share of its probes that see it.
void main()
{
  int index = atlas_index();
  visibility = 0.0;
  if (index >= sample_total) {
    return;
  }
  int owner = atlas_owner(index);
  vec4 first = fetch_row(segments, 3 * owner);
  vec4 last = fetch_row(segments, 3 * owner + 1);
  vec4 own = fetch_row(segments, 3 * owner + 2);
  Line line = Line(own.xy, own.z);
  float j = float(index) - first.w;
  int seen = 0;
  for (int k = 0; k < probes; k++) {
    float t = (j + (float(k) + 0.5) / float(probes)) / last.w;
    vec3 place = mix(first.xyz, last.xyz, t);
    seen += depth_sees(line, place.xy, place.z) ? 1 : 0;
  }
  visibility = float(seen) / float(probes);
}
