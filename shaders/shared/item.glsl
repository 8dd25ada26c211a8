// SPDX-License-Identifier: GPL-3.0-or-later
// The depth test of the item buffer (native/fovea/visibility/item_buffer.h). Also compiled as C++, as members of a
// struct.

// Whether a texel hides a line that passes through it at `line_depth`.
//   plane         the texel's depth, and its change per pixel to the right and up
//   buffer_scale  texels per pixel
bool item_hidden(vec3 plane, float line_depth, float buffer_scale, float slope_factor, float bias)
{
  float step = max(abs(plane.y), abs(plane.z)) / buffer_scale;
  return plane.x - line_depth > step * slope_factor + plane.x * bias;
}
