// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by principal highlights of ridges and valleys.
#pragma once

#include <limits>

#include <fovea/line/seen_vertices.h>
#include <fovea/line/threshold.h>
#include <fovea/line/zero_set.h>

namespace fovea::line {

inline Parameters<ThresholdValues> principal_highlight_parameters() {
    return threshold_parameters<ThresholdValues>(
        0.015, 0.5, 3.0,
        "Difference of the squared curvatures times n . v that a line reaches somewhere, in "
        "units of 1 / feature size squared");
}

/// Zeros of v . e1 where sign * k1 > 0 and (k1^2 - k2^2) n . v is above the threshold (and so n . v > 0). e1 has no
/// sign: within a triangle, the corners' directions are flipped to agree with that of the corner with the greatest
/// |k1|. Skipped are triangles in which a corner's e1 differs from it by more than 45 degrees as a line, and those with
/// a corner where |k2| is almost |k1| (an umbilic, or a swap of e1 and e2), as e1 is unreliable there.
inline Curves find_principal_highlights(const SurfaceView& seen, const ThresholdValues& values, float sign) {
    constexpr float least_cosine = 0.70710678f, greatest_ratio = 0.98f;  // of |k2| / |k1|
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    const Thresholds thresholds(surface, values, 2);
    Array<float> along(surface.vertex_count()), above(along.size());
    parallel_for(along.size(), [&](std::size_t v) {
        const Curvature& c = fields->curvature[v];
        const SeenOf<float> s = see_vertex(seen, c, static_cast<Index>(v));
        const bool known = sign * c.k1 > 0.0f && std::abs(c.k2) < greatest_ratio * std::abs(c.k1);
        // NaN yields no crossing. Zeros are made slightly positive in the direction of the vertex's own e1, so that
        // later sign flips treat them consistently.
        along[v] = !known ? std::nanf("") : s.u == 0.0f ? std::numeric_limits<float>::min() : s.u;
        above[v] = (c.k1 * c.k1 - c.k2 * c.k2) * s.facing - thresholds.low;
    });
    const auto sides = triangle_sides(surface);
    return collect_pieces(surface.triangles.size(), [&](Index triangle, Array<CurvePiece>& out) {
        const Triangle& t = surface.triangles[triangle];
        const auto curvature = [&](Index v) -> const Curvature& { return fields->curvature[v]; };
        const auto bend = [&](Index v) { return std::abs(curvature(v).k1); };
        Index most = t.x;
        for (const Index v : {t.y, t.z})
            if (bend(v) > bend(most)) most = v;
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(glm::dot(curvature(most).e1, curvature(t[i]).e1)) > least_cosine)) return;
        const auto value = [&](Index v) {
            return glm::dot(curvature(most).e1, curvature(v).e1) < 0.0f ? -along[v] : along[v];
        };
        append_zero(surface, *sides, triangle, value, [&](Index v) { return above[v]; }, thresholds, out);
    });
}

}  // namespace fovea::line
