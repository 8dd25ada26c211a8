void main()
{
  // gl_FragCoord.w is 1 / w, linear on the screen: so is depth, and it keeps its precision far away.
  float depth = depth_w * gl_FragCoord.w;
  texel = vec4(depth, dFdx(depth) * buffer_scale, dFdy(depth) * buffer_scale, facet_number);
  // More precise than what clip space leaves of it, far away.
#ifdef WRITES_DEPTH
  gl_FragDepth = depth * window_depth.x + window_depth.y;
#endif
}
