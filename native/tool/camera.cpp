// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/camera.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include <fovea/base/check.h>
#include <fovea/base/elementary.h>

namespace fovea::tool {
namespace {

/// Rotation from model space to camera space: x right, y up, z towards the viewer.
dmat3 turned(const Camera& camera, bool y_up) {
    const double a = glm::radians(camera.azimuth), e = glm::radians(camera.elevation);
    const dvec3 right(cosine(a), -sine(a), 0.0);
    const dvec3 back(-sine(a) * cosine(e), -cosine(a) * cosine(e), sine(e));
    const dmat3 axes = glm::transpose(dmat3(right, glm::cross(back, right), back));
    return y_up ? axes * dmat3({1, 0, 0}, {0, 0, 1}, {0, -1, 0}) : axes;
}

/// Accumulates constraints on the camera's position along one axis of its frame; `half`: half the frame's extent at
/// distance 1.
struct Side {
    double half, above = -1e300, below = -1e300;
    void hold(double across, double z) {
        above = std::max(above, half * z + across);
        below = std::max(below, half * z - across);
    }
    double middle() const { return (above - below) / 2.0; }
    double distance() const { return (above + below) / (2.0 * half); }
};

}  // namespace

View view_of(In<vec3> positions, const Camera& camera, bool y_up) {
    check(camera.width > 0 && camera.height > 0, "a picture has at least one pixel");
    check(camera.lens > 0.0 && camera.margin >= 0.0 && camera.margin < 50.0, "a lens or margin leaves no picture");
    const dmat3 axes = turned(camera, y_up);
    const double free = 1.0 - camera.margin / 50.0, longer = std::max(camera.width, camera.height);
    const dvec2 half = 18.0 / camera.lens * dvec2(camera.width, camera.height) / longer;
    Side x{half.x * free}, y{half.y * free};
    double low = 1e300, high = -1e300;
    for (const vec3& position : positions) {
        const dvec3 p = axes * dvec3(position);
        if (!std::isfinite(p.x + p.y + p.z)) continue;
        x.hold(p.x, p.z);
        y.hold(p.y, p.z);
        low = std::min(low, p.z);
        high = std::max(high, p.z);
    }
    if (low > high) low = high = 0.0, x.hold(0.0, 0.0), y.hold(0.0, 0.0);
    // A single point is viewed from a distance of 1.
    dvec3 eye(x.middle(), y.middle(), std::max(x.distance(), y.distance()));
    if (!(eye.z > low)) eye.z = low + 1.0;
    View view;
    view.world_to_view = glm::translate(dmat4(1.0), -eye) * dmat4(axes);
    view.width = camera.width;
    view.height = camera.height;
    view.near_clip = std::max((eye.z - high) * 0.5, (eye.z - low) * 1e-4);
    view.far_clip = (eye.z - low) * 2.0;
    const dvec2 side = half * view.near_clip;
    view.view_to_clip = glm::frustum(-side.x, side.x, -side.y, side.y, view.near_clip, view.far_clip);
    view.reference_scale = camera.height / 1080.0;
    view.frame = dvec4(0.0, 0.0, camera.width, camera.height);
    return view;
}

}  // namespace fovea::tool
