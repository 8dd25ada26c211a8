// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/base/view.h>

#include <fovea/base/check.h>

namespace fovea::base {
namespace {

constexpr double least_near = 1e-20;  // distances a million times smaller are still numbers, in single precision

constexpr double least_magnification = 1e-30;  // below it places of pixels in space are no numbers, in single precision

constexpr double least_scale = 1e-4, most_scale = 1e4;  // image pixels per reference pixel

/// Whether products of its numbers are numbers, too.
bool is_moderate(const dmat4& matrix) {
    constexpr double most = 1e30;
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) sum += glm::dot(glm::abs(matrix[i]), dvec4(1.0));
    return sum < most;
}

}  // namespace

void check_view(const View& view) {
    check(view.width > 0 && view.height > 0, "camera: its picture has no pixels; make it wider or higher");
    check(is_moderate(view.world_to_view) && glm::determinant(view.world_to_view) != 0.0,
          "camera: it looks in no direction; reset its location, rotation and scale");
    const bool shows = is_moderate(view.view_to_clip) && glm::determinant(view.view_to_clip) != 0.0 &&
                       std::abs(view.view_to_clip[0][0]) > least_magnification &&
                       std::abs(view.view_to_clip[1][1]) > least_magnification && view.view_to_clip[0][3] == 0.0 &&
                       view.view_to_clip[1][3] == 0.0;  // a lens is not tilted
    check(shows, "camera: it shows nothing; reset its focal length, sensor, shift and clip distances");
    check(view.near_clip >= least_near || view.orthographic, "camera: its Clip Start must be more than 0");
    check(view.far_clip > view.near_clip && std::isfinite(view.far_clip) && std::isfinite(view.near_clip),
          "camera: it sees nothing; set its Clip Start below its Clip End");
    check(
        view.reference_scale >= least_scale && view.reference_scale <= most_scale,
        "camera: its whole frame is less than a tenth of a pixel or more than ten million pixels high; zoom in or out");
    check(glm::dot(glm::abs(view.frame), dvec4(1.0)) < 1e12,
          "camera: its frame is not finite; reset its sensor and shift");
}

}  // namespace fovea::base
