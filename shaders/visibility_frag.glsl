// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility of the atlas sample at this fragment: share of its probes that are not hidden. Samples outside of the
// tile's core keep their values.
void main()
{
  int index = atlas_index();
  visibility = 0.0;
  if (index >= sample_total) {
    return;
  }
  AtlasSample here = atlas_sample(index);
  vec4 own = fetch_row(segments, 3 * here.owner + 2);
  float count = here.last.w;
  visibility = depth_share(Line(own.xy, own.z), here.first.xyz, here.last.xyz, here.j / count, (here.j + 1.0) / count);
}
