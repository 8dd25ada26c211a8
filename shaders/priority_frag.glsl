// SPDX-License-Identifier: GPL-3.0-or-later
// One layer of the priority buffer (native/fovea/elision/priority_buffer.h); the second skips bands within 45 degrees
// of the one in the first.
void main()
{
  float coverage = band_coverage(place);
  if (coverage < 0.5 / 255.0) {
    discard;
  }
  if (layers_in_front > 0) {
    vec4 first = unpacked_texel(texelFetch(layer0, ivec2(gl_FragCoord.xy), 0).xy);
    if (first.x == line_owner.z || !bands_cross(first.zw, line_owner.xy)) {
      discard;
    }
  }
  vec2 away = line_owner.xy * band_side(place);
  band_texel = packed_texel(vec4(line_owner.z, band_ends_right(place) ? -coverage : coverage, away));
}
