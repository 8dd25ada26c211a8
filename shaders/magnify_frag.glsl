// SPDX-License-Identifier: GPL-3.0-or-later
// Shows a picture at any size, with bilinear interpolation; beyond it, its border goes on.

#ifdef OVERLAY
// sRGB of a scene-linear color.
vec3 displayed(vec3 linear)
{
    vec3 value = clamp(linear, 0.0, 1.0);
    return mix(12.92 * value, 1.055 * pow(value, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), value));
}
#endif

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
    color.rgb = displayed(color.rgb / max(color.a, 1e-6)) * color.a;
    color *= is_inside ? opacity : 0.0;
#endif
}
