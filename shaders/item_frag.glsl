// SPDX-License-Identifier: GPL-3.0-or-later
// One layer of the item buffer (native/fovea/visibility/item_buffer.h): lines that pass the depth test and are not in a
// layer in front.
void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(depth_buffer, texel, 0);
  if (here.w >= 0.0 && item_hidden(here.xyz, line_depth, buffer_scale, slope_factor, bias)) {
    discard;
  }
  if ((layers_in_front > 0 && texelFetch(layer0, texel, 0).x == item_number) ||
      (layers_in_front > 1 && texelFetch(layer1, texel, 0).x == item_number))
  {
    discard;
  }
  item = item_number;
}
