// SPDX-License-Identifier: GPL-3.0-or-later
// One layer of the priority buffer (native/fovea/elision/priority_buffer.h); the second skips bands within 45 degrees
// of the one in the first.
void main()
{
  float coverage = min(1.0, place.y + 0.5 - abs(place.x));
  if (coverage < 0.5 / 255.0) {
    discard;
  }
  if (layers_in_front > 0) {
    vec4 first = unpacked_texel(texelFetch(layer0, ivec2(gl_FragCoord.xy), 0).xy);
    float cosine = dot(first.zw, line_owner.xy);
    if (first.x == line_owner.z || cosine * cosine >= 0.5 * dot(first.zw, first.zw)) {
      discard;
    }
  }
  float side = place.x < 0.0 ? -1.0 : 1.0, length = 1.0 - 0.5 * min(1.0, abs(place.z));
  bool right = (place.z > 0.0) == (side > 0.0);
  texel = packed_texel(vec4(line_owner.z, right ? -coverage : coverage, line_owner.xy * (side * length)));
}
