// Visibility of the atlas sample at this fragment by the item buffer: item_visibility of native/atlas/item_buffer.cpp.
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
  int owner = atlas_owner(index);
  vec4 first = fetch_row(segments, 3 * owner);
  vec4 last = fetch_row(segments, 3 * owner + 1);
  float item = fetch_row(items, owner).x;
  float j = float(index) - first.w;
  if (!atlas_in_tile(mix(first.xy, last.xy, (j + 0.5) / last.w))) {
    discard;
  }
  vec2 way = abs(last.xy - first.xy);
  ivec2 across = way.x >= way.y ? ivec2(0, 1) : ivec2(1, 0);
  float seen = 0.0;
  for (float k = 0.5; k < buffer_scale; k += 1.0) {
    vec2 at = (mix(first.xy, last.xy, (j + k / buffer_scale) / last.w) + border) * buffer_scale;
    ivec2 texel = ivec2(floor(at));
    if (layers_hold(texel, item) || layers_hold(texel - across, item) || layers_hold(texel + across, item)) {
      seen += 1.0;
    }
  }
  visibility = seen / buffer_scale;
}
