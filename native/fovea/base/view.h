// SPDX-License-Identifier: GPL-3.0-or-later
// Camera and image size.
#pragma once

#include <algorithm>
#include <cmath>

#include <fovea/base/types.h>

namespace fovea::base {

/// Height of an image in which a pixel is one reference pixel; px.
inline constexpr double reference_height = 1080.0;

/// Camera and image. View space: eye at the origin, looking along -z, x right, y up. Clip space as in OpenGL. Pixels:
/// origin at the lower left corner of the rendered region, y up, pixel centers at .5.
struct View {
    dmat4 world_to_view{1.0};
    /// Includes the crop of a render border, lens shift and pixel aspect.
    dmat4 view_to_clip{1.0};
    int width = 0;
    int height = 0;
    bool orthographic = false;
    /// Clip distances in view space, positive.
    double near_clip = 0.1;
    double far_clip = 1000.0;
    /// Image pixels per reference pixel: height of the full frame / 1080.
    double reference_scale = 1.0;
    /// The camera's full frame, of which a render border or viewport may show a part: left, lower, width, height, in px
    /// of this image.
    dvec4 frame{0.0};

    /// A light's view, of all around it, has none (scene/light_view.h).
    bool has_near_plane() const { return near_clip > 0.0; }
};

/// Throws std::invalid_argument for a view that shows nothing.
void check_view(const View& view);

/// The same view at `scale` times the resolution, width and height rounded, at least 1.
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

/// Pixel position of a clip-space point; meaningless where clip.w <= 0.
inline dvec2 to_pixels(const View& view, const dvec4& clip) {
    return {(clip.x / clip.w * 0.5 + 0.5) * view.width, (clip.y / clip.w * 0.5 + 0.5) * view.height};
}

/// View-space point of the near plane under a pixel position. `clip_to_view`: inverse of view_to_clip.
inline dvec3 on_near_plane(const View& view, const dmat4& clip_to_view, const dvec2& px) {
    const dvec2 ndc(px.x / view.width * 2.0 - 1.0, px.y / view.height * 2.0 - 1.0);
    const dvec4 point = clip_to_view * dvec4(ndc, -1.0, 1.0);
    return dvec3(point) / point.w;
}

/// View-space point under a pixel position at a given distance along -z.
inline dvec3 from_pixels(const View& view, const dmat4& clip_to_view, const dvec2& px, double distance) {
    const dvec3 point = on_near_plane(view, clip_to_view, px);
    return view.orthographic ? dvec3(point.x, point.y, -distance) : point * (distance / -point.z);
}

/// Depth as all stages compare it: linear over the screen, reversed (larger is nearer), 1 at the near plane.
/// Perspective: near / distance, 0 at infinity. Orthographic: 0 at the far plane. Reversed so that floats keep their
/// relative precision at every distance.
inline double screen_depth(const View& view, double z_view) {
    return view.orthographic ? (view.far_clip + z_view) / (view.far_clip - view.near_clip) : view.near_clip / -z_view;
}

/// Share of the way in space between two points at these distances along -z, at this share of the way on the screen;
/// with the distances exchanged the other way around. Without differences: exact at both ends, however far they are.
inline double share_in_space(double on_screen, double from, double to) {
    return on_screen * from / glm::mix(to, from, on_screen);
}

}  // namespace fovea::base
