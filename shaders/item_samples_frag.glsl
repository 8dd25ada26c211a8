// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility of the atlas sample at this fragment from the item buffer (native/fovea/visibility/item_buffer.cpp,
// item_visibility).
bool layers_hold(ivec2 texel, float item)
{
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, textureSize(layer0, 0)))) {
    return false;
  }
  return texelFetch(layer0, texel, 0).x == item || (layer_count > 1 && texelFetch(layer1, texel, 0).x == item) ||
         (layer_count > 2 && texelFetch(layer2, texel, 0).x == item);
}

void main()
{
  int index = atlas_index();
  visibility = 0.0;
  if (index >= sample_total) {
    return;
  }
  AtlasSample here = atlas_sample(index);
  vec2 start = here.first.xy, end = here.last.xy, way = abs(end - start);
  float item = fetch_row(items, here.owner).x;
  ivec2 across = way.x >= way.y ? ivec2(0, 1) : ivec2(1, 0);
  float seen = 0.0;
  for (float k = 0.5; k < buffer_scale; k += 1.0) {
    vec2 at = (mix(start, end, (here.j + k / buffer_scale) / here.last.w) + border) * buffer_scale;
    ivec2 texel = ivec2(floor(at));
    if (layers_hold(texel, item) || layers_hold(texel - across, item) || layers_hold(texel + across, item)) {
      seen += 1.0;
    }
  }
  visibility = seen / buffer_scale;
}
