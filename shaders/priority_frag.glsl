// One layer of the priority buffer (native/elision/priority_buffer.h); the second leaves out what goes along the line
// that has the first. Texels: rank (0: nobody's), share of the pixel that the band covers, and the unit vector across
// the line, away from its middle towards the pixel.
void main()
{
  float coverage = min(1.0, place.y + 0.5 - abs(place.x));
  if (coverage < 0.5 / 255.0) {
    discard;
  }
  if (layers_in_front > 0) {
    vec4 first = texelFetch(layer0, ivec2(gl_FragCoord.xy), 0);
    float cosine = dot(first.zw, line_owner.xy);
    if (first.x == line_owner.z || cosine * cosine >= 0.5) {
      discard;
    }
  }
  texel = vec4(line_owner.z, coverage, place.x < 0.0 ? -line_owner.xy : line_owner.xy);
}
