// The elision test for the sample at this fragment: crowding() of native/elision/elide.cpp.
struct Own {
  vec4 place;       // pixel position, direction
  vec4 band;        // half width, rank, pixels back to the run's start and ahead to its end
  vec4 at_ends;     // ranks at the run's ends
  vec4 meets;       // how much these lines meet it there
  float shortness;  // how much it is a mere tick
};

bool in_buffer(ivec2 texel)
{
  return all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, textureSize(layer0, 0)));
}

// The part of a pixel that another line takes away.
float lost(vec4 other, Own line, float own, vec2 away)
{
  if (other.x <= line.band.y) {
    return 0.0;
  }
  float cosine = dot(away, other.zw), squared = cosine * cosine;
  vec4 meets = line.meets * vec4(equal(line.at_ends, vec4(other.x)));
  float met = max(max(meets.x, meets.y), max(meets.z, meets.w));
  float weight = mix(smoothstep(0.25, 0.75, squared), smoothstep(0.8214, 0.9698, squared), met);
  float both = cosine < 0.0 ? max(0.0, own + other.y - 1.0) : min(own, other.y);
  return max(weight, line.shortness) * both;
}

// (lost, own) share of the pixel that a place of the window is in.
vec2 window_pixel(vec2 at, Own line)
{
  ivec2 pixel = ivec2(floor(at)), texel = pixel - ivec2(buffer_origin);
  if (!in_buffer(texel)) {
    return vec2(0.0);
  }
  vec2 from = vec2(pixel) + 0.5 - line.place.xy, left = vec2(-line.place.w, line.place.z);
  float u = dot(from, line.place.zw), v = dot(from, left);
  float inside = clamp(u + line.band.z + 0.5, 0.0, 1.0) * clamp(line.band.w - u + 0.5, 0.0, 1.0);
  float own = clamp(line.band.x + 0.5 - abs(v), 0.0, 1.0);
  vec2 away = v < 0.0 ? -left : left;
  float first = lost(texelFetch(layer0, texel, 0), line, own, away);
  float second = lost(texelFetch(layer1, texel, 0), line, own, away);
  return inside * vec2(max(first, second), own);
}

// Rank and coverage of both layers at a pixel position.
vec4 bands_at(vec2 px)
{
  ivec2 texel = ivec2(floor(px)) - ivec2(buffer_origin);
  return in_buffer(texel) ? vec4(texelFetch(layer0, texel, 0).xy, texelFetch(layer1, texel, 0).xy) : vec4(0.0);
}

void main()
{
  int index = int(gl_FragCoord.y) * ROW_WIDTH + int(gl_FragCoord.x);
  crowding = vec2(0.0);
  if (index >= sample_total) {
    return;
  }
  vec4 place = fetch_row(places, index), band = fetch_row(bands, index), end = fetch_row(ends, index);
  if (any(lessThan(place.xy, tile.xy)) || any(greaterThanEqual(place.xy, tile.zw))) {
    discard;
  }
  float shortness = 1.0 - smoothstep(band.x, 3.0 * band.x, band.z + band.w);
  vec4 start_bands = bands_at(end.xy), end_bands = bands_at(end.zw);
  vec2 near = 1.0 - smoothstep(vec2(0.5 * end_reach * band.x), vec2(end_reach * band.x), band.zw);
  vec4 meets = vec4(start_bands.yw * near.x, end_bands.yw * near.y);
  Own line = Own(place, band, vec4(start_bands.xz, end_bands.xz), meets, shortness);
  float width = 2.0 * band.x + 1.0;
  int rows = min(most_rows, int(ceil(2.0 * width)));
  vec2 left = vec2(-place.w, place.z);
  for (int j = 0; j < columns; j++) {
    float shift = (float(j) + 0.5) / float(columns);
    vec2 column = place.xy + place.zw * ((shift - 0.5) * window_length);
    for (int k = 0; k < rows; k++) {
      crowding += window_pixel(column + left * (((float(k) + shift) / float(rows) - 0.5) * width), line);
    }
  }
}
