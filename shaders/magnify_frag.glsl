// SPDX-License-Identifier: GPL-3.0-or-later
// Magnifies a picture to a region, with bilinear interpolation.

void main()
{
    vec2 picture_size = vec2(textureSize(picture, 0));
    vec2 place = gl_FragCoord.xy / region_size * picture_size - 0.5;
    vec2 share = fract(place);
    ivec2 first = ivec2(floor(place)), last = ivec2(picture_size) - 1;
    ivec2 low = clamp(first, ivec2(0), last), high = clamp(first + 1, ivec2(0), last);
    vec4 below = mix(texelFetch(picture, low, 0), texelFetch(picture, ivec2(high.x, low.y), 0), share.x);
    vec4 above = mix(texelFetch(picture, ivec2(low.x, high.y), 0), texelFetch(picture, high, 0), share.x);
    color = mix(below, above, share.y);
}
