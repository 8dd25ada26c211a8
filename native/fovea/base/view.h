// SPDX-License-Identifier: GPL-3.0-or-later
// A camera and the image it makes.
#pragma once

#include <algorithm>
#include <cmath>

#include <fovea/base/types.h>

namespace fovea::base {

/// Pixels: of an image so high, pixels are reference pixels.
inline constexpr double reference_height = 1080.0;

/// Camera and image. View space: eye at the origin, looking along -z, x right, y up. Clip space as in OpenGL.
/// Pixels: origin at the lower left corner of the drawn region, y up, pixel centers at .5.
struct View {
    dmat4 world_to_view{1.0};
    /// Crop for a render border, lens shift and pixel aspect are already in it.
    dmat4 view_to_clip{1.0};
    int width = 0;
    int height = 0;
    bool orthographic = false;
    /// Clip distances in view space, positive.
    double near_clip = 0.1;
    double far_clip = 1000.0;
    /// Image pixels per reference pixel (height of the full frame / 1080).
    double reference_scale = 1.0;
    /// The camera's full frame, of which a render border or a viewport shows a part: left, lower, width, height [px].
    dvec4 frame{0.0};
};

/// The same part of the world in fewer pixels, `scale` times as many along each axis, rounded to a whole picture.
inline View smaller(const View& view, double scale) {
    const auto side = [&](int pixels) { return std::max(1, int(std::nearbyint(pixels * scale))); };
    View made = view;
    made.width = side(view.width);
    made.height = side(view.height);
    const double x = double(made.width) / view.width, y = double(made.height) / view.height;
    made.frame *= dvec4(x, y, x, y);
    made.reference_scale *= y;
    return made;
}

/// Pixel position of a view-space point; meaningless where `clip_w` <= 0.
inline dvec2 to_pixels(const View& view, const dvec4& clip) {
    return {(clip.x / clip.w * 0.5 + 0.5) * view.width, (clip.y / clip.w * 0.5 + 0.5) * view.height};
}

/// Where the way to a pixel position crosses the near plane, in view space. `clip_to_view`: inverse of view_to_clip.
inline dvec3 on_near_plane(const View& view, const dmat4& clip_to_view, const dvec2& px) {
    const dvec2 ndc(px.x / view.width * 2.0 - 1.0, px.y / view.height * 2.0 - 1.0);
    const dvec4 point = clip_to_view * dvec4(ndc, -1.0, 1.0);
    return dvec3(point) / point.w;
}

/// The view-space point at a pixel position whose distance along -z is given.
inline dvec3 from_pixels(const View& view, const dmat4& clip_to_view, const dvec2& px, double distance) {
    const dvec3 point = on_near_plane(view, clip_to_view, px);
    return view.orthographic ? dvec3(point.x, point.y, -distance) : point * (distance / -point.z);
}

/// Depth as every stage compares it: screen-linear, reversed (larger is nearer), 1 at the near plane. Perspective:
/// near / distance, 0 at infinity. Orthographic: 0 at the far plane. Keeps float precision at every distance.
inline double screen_depth(const View& view, double z_view) {
    return view.orthographic ? (view.far_clip + z_view) / (view.far_clip - view.near_clip) : view.near_clip / -z_view;
}

}  // namespace fovea::base
