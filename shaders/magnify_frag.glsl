// SPDX-License-Identifier: GPL-3.0-or-later
// Shows a picture at any size, with bilinear interpolation; beyond it, its border goes on.

void main()
{
    vec2 picture_size = vec2(textureSize(picture, 0));
    vec2 texel = share * picture_size - 0.5;
    vec2 between = fract(texel);
    ivec2 first = ivec2(floor(texel)), last = ivec2(picture_size) - 1;
    ivec2 low = clamp(first, ivec2(0), last), high = clamp(first + 1, ivec2(0), last);
    vec4 below = mix(texelFetch(picture, low, 0), texelFetch(picture, ivec2(high.x, low.y), 0), between.x);
    vec4 above = mix(texelFetch(picture, ivec2(low.x, high.y), 0), texelFetch(picture, high, 0), between.x);
    color = mix(below, above, between.y);
#ifdef OVERLAY
    bool is_inside = all(greaterThanEqual(gl_FragCoord.xy, inside.xy)) && all(lessThan(gl_FragCoord.xy, inside.zw));
    color *= is_inside ? opacity : 0.0;
#endif
}
