// SPDX-License-Identifier: GPL-3.0-or-later
// Texels of the priority buffer: PriorityTexel of native/fovea/elision/priority_buffer.h, of the same precision in
// another layout. Unpacked: rank (0: none), coverage of the pixel by the band (negative if the band's nearer end lies
// to the right of the following vector), and the vector across the line, from its center towards the pixel.
uvec2 packed_texel(vec4 texel)
{
  uint covered = uint(abs(texel.y) * 255.0 + 0.5) | (texel.y < 0.0 ? 256u : 0u);
  ivec2 away = ivec2(floor(texel.zw * 16383.0 + 0.5));
  return uvec2(uint(texel.x) << 9 | covered, uint(away.x << 16 | away.y & 0xFFFF));
}

// Rank, and coverage of the pixel.
vec2 owner_of(uvec2 texel)
{
  return vec2(texel.x >> 9, float(texel.x & 255u) / 255.0);
}

vec4 unpacked_texel(uvec2 texel)
{
  int away = int(texel.y);
  vec2 owner = owner_of(texel);
  return vec4(owner.x, (texel.x & 256u) != 0u ? -owner.y : owner.y, vec2(away >> 16, away << 16 >> 16) / 16383.0);
}
