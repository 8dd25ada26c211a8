// The elision test for the atlas sample at this fragment: crowding() of native/elision/elide.cpp.

// The part of a pixel that another line takes away, `least` at any angle.
float lost(vec4 other, float rank, float own, vec2 away, float least)
{
  if (other.x <= rank) {
    return 0.0;
  }
  float cosine = dot(away, other.zw);
  float along = max(least, smoothstep(0.25, 0.75, cosine * cosine));
  return along * (cosine < 0.0 ? max(0.0, own + other.y - 1.0) : min(own, other.y));
}

// Lost and own share of the pixel that a place of the window is in.
vec2 window_pixel(vec2 at, vec4 here, vec4 band, float shortness)
{
  ivec2 pixel = ivec2(floor(at)), texel = pixel - ivec2(buffer_origin);
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, textureSize(layer0, 0)))) {
    return vec2(0.0);
  }
  vec2 from = vec2(pixel) + 0.5 - here.xy, left = vec2(-here.w, here.z);
  float u = dot(from, here.zw), v = dot(from, left);
  float inside = clamp(u + band.z + 0.5, 0.0, 1.0) * clamp(band.w - u + 0.5, 0.0, 1.0);
  float own = clamp(band.x + 0.5 - abs(v), 0.0, 1.0);
  if (own * inside <= 0.0) {
    return vec2(0.0);
  }
  vec2 away = v < 0.0 ? -left : left;
  float first = lost(texelFetch(layer0, texel, 0), band.y, own, away, shortness);
  float second = lost(texelFetch(layer1, texel, 0), band.y, own, away, shortness);
  return inside * vec2(max(first, second), own);
}

void main()
{
  int index = int(gl_FragCoord.y) * ROW_WIDTH + int(gl_FragCoord.x);
  crowding = vec2(0.0);
  if (index >= sample_total) {
    return;
  }
  vec4 here = fetch_row(places, index), band = fetch_row(bands, index);
  if (any(lessThan(here.xy, tile.xy)) || any(greaterThanEqual(here.xy, tile.zw))) {
    discard;
  }
  if (band.y == 0.0) {
    return;
  }
  float shortness = 1.0 - smoothstep(band.x, 3.0 * band.x, band.z + band.w);
  float width = 2.0 * band.x + 1.0;
  int rows = min(most_rows, int(ceil(2.0 * width)));
  vec2 left = vec2(-here.w, here.z);
  for (int j = 0; j < columns; j++) {
    vec2 column = here.xy + here.zw * float(j - columns / 2);
    float shift = (float(j) + 0.5) / float(columns);
    for (int k = 0; k < rows; k++) {
      vec2 at = column + left * (((float(k) + shift) / float(rows) - 0.5) * width);
      crowding += window_pixel(at, here, band, shortness);
    }
  }
}
