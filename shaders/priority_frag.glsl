// One layer of the priority buffer (native/elision/priority_buffer.h); the second leaves out what goes along the line
// that has the first. Texels: rank (0: nobody's), share of the pixel that the band covers (negative where its nearer end
// lies to the right of what follows), and the vector across the line, away from its middle towards the pixel.
void main()
{
  float coverage = min(1.0, place.y + 0.5 - abs(place.x));
  if (coverage < 0.5 / 255.0) {
    discard;
  }
  if (layers_in_front > 0) {
    vec4 first = texelFetch(layer0, ivec2(gl_FragCoord.xy), 0);
    float cosine = dot(first.zw, line_owner.xy);
    if (first.x == line_owner.z || cosine * cosine >= 0.5 * dot(first.zw, first.zw)) {
      discard;
    }
  }
  float side = place.x < 0.0 ? -1.0 : 1.0, length = 1.0 - 0.5 * min(1.0, abs(place.z));
  bool right = (place.z > 0.0) == (side > 0.0);
  texel = vec4(line_owner.z, right ? -coverage : coverage, line_owner.xy * (side * length));
}
