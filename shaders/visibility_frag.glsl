// Visibility of the atlas sample at this fragment: the share of its probes that see it. Other tiles' samples stay.
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
  float j = float(index) - first.w;
  if (!atlas_in_tile(mix(first.xy, last.xy, (j + 0.5) / last.w))) {
    discard;
  }
  visibility = depth_share(Line(own.xy, own.z), first.xyz, last.xyz, j / last.w, (j + 1.0) / last.w);
}
