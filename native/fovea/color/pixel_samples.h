// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels at edges of colors: which are, and the samples that they get.
#pragma once

#include <algorithm>
#include <optional>

#include <fovea/color/shader.h>
#include <fovea/image/lattice.h>
#include <fovea/scene/tracer.h>

namespace fovea::color {

inline constexpr int sample_bits = 4, fine_samples = 1 << sample_bits;
/// Difference of display colors above which a pixel gets the fine samples.
inline constexpr float fine_color = 1.0f / 96.0f;

inline dvec2 middle_of(int x, int y) { return {x + 0.5, y + 0.5}; }
/// Sample i of the fine ones of a pixel, in pixels.
inline dvec2 fine_sample(int x, int y, int i) { return middle_of(x, y) + image::place_in_square(i, sample_bits); }

/// Whether visit(x, y) is true for one of the pixels around a pixel, itself among them; ends with the first.
template <typename Visit>
bool any_around(const View& view, int x, int y, const Visit& visit) {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, view.height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, view.width - 1); ++u)
            if (visit(u, v)) return true;
    return false;
}

/// Where a triangle is met at a place of the image: its barycentrics, not normalized, and its distance along the view
/// axis.
struct Met {
    dvec3 share;
    double distance;
};

/// Triangles at places of the image, as the camera and the section plane leave them.
class Meeting {
   public:
    /// Borrows.
    explicit Meeting(const Tracer& tracer) : tracer_(tracer), clip_to_view_(glm::inverse(tracer.view().view_to_clip)) {}

    /// `slack`: of shares outside the triangle, of their sum, so that nothing is missed between two.
    std::optional<Met> at(const SeenTriangle& triangle, const dvec2& px, double slack = 0.0) const {
        const dvec3 share = triangle.screen.at(px);
        if (!ScreenTriangle::covers(slack > 0.0 ? share + slack * (share.x + share.y + share.z) : share)) return {};
        const double distance = triangle.screen.distance(share);
        const View& view = tracer_.view();
        if (!(distance >= view.near_clip) || tracer_.cuts_away(from_pixels(view, clip_to_view_, px, distance)))
            return {};
        return Met{share, distance};
    }

   private:
    const Tracer& tracer_;
    dmat4 clip_to_view_;
};

}  // namespace fovea::color
