// SPDX-License-Identifier: GPL-3.0-or-later
// The depth test of the item buffer (native/fovea/visibility/item_buffer.h). Also compiled as C++, as members of a
// struct.

// Whether a texel hides a line that passes through it at `depth`.
//   plane          the texel's depth, and its change per pixel to the right and up
//   texels_per_px  scale of the buffer
//   slope, slack   what lies in front by less hides nothing: slope in changes of depth from texel to texel, slack in
//                  the texel's depth
bool item_hidden(vec3 plane, float depth, float texels_per_px, float slope, float slack)
{
  float change = max(abs(plane.y), abs(plane.z)) / texels_per_px;
  return plane.x - depth > change * slope + plane.x * slack;
}
