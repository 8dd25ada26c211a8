// SPDX-License-Identifier: GPL-3.0-or-later
// Barycentric coordinates of a triangle as functions of pixel position.
#pragma once

#include <fovea/base/view.h>

namespace fovea::color {

/// Maps pixel positions (x, y, 1) to ray directions with z = -1 (perspective), or to points (x, y, 1) of the image
/// plane (orthographic).
inline dmat3 pixel_to_ray(const View& view) {
    const dmat4 clip_to_view = glm::inverse(view.view_to_clip);
    const double w = view.width, h = view.height;
    const auto at = [&](double x, double y) {
        const dvec3 p = from_pixels(view, clip_to_view, {x, y}, 1.0);
        return dvec3(p.x, p.y, view.orthographic ? 1.0 : -1.0);
    };
    const dvec3 origin = at(0.0, 0.0);
    return dmat3((at(w, 0.0) - origin) / w, (at(0.0, h) - origin) / h, origin);
}

/// Homogeneous barycentric coordinates, linear over the image up to a common factor (Olano & Greer, "Triangle Scan
/// Conversion using 2D Homogeneous Coordinates", Graphics Hardware 1997): no clipping is needed, and corners may lie
/// behind the eye.
struct ScreenTriangle {
    dmat3 shares{0.0};     ///< (x, y, 1) to unnormalized barycentrics; not finite if edge-on
    dvec3 distances{0.0};  ///< of the corners along -z
    bool orthographic = false;

    ScreenTriangle() = default;
    /// Corners in view space.
    ScreenTriangle(const dvec3 corner[3], const dmat3& ray, bool flat) : orthographic(flat) {
        dmat3 m(corner[0], corner[1], corner[2]);
        for (int i = 0; i < 3; ++i) {
            distances[i] = -corner[i].z;
            if (orthographic) m[i].z = 1.0;
        }
        shares = glm::inverse(m) * ray;
    }

    dvec3 at(const dvec2& px) const { return shares * dvec3(px, 1.0); }
    /// Whether the triangle covers the pixel position of the barycentrics from `at`; false where these are not finite.
    static bool covers(const dvec3& share) {
        return share.x >= 0.0 && share.y >= 0.0 && share.z >= 0.0 && share.x + share.y + share.z > 0.0;
    }
    double distance(const dvec3& share) const {
        const double sum = share.x + share.y + share.z;
        return orthographic ? glm::dot(share, distances) / sum : 1.0 / sum;
    }
};

}  // namespace fovea::color
