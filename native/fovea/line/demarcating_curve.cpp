// SPDX-License-Identifier: GPL-3.0-or-later
// Demarcating curve: where a valley turns into a ridge. Kolomenkin, Shimshoni & Tal, "Demarcating Curves for Shape
// Illustration", SIGGRAPH Asia 2008.
// In   curvature and its derivative
// Out  zeros of the curvature along g, the direction in which curvature changes fastest. Triangles whose corners
//      disagree about g by more than 45 degrees have no line, as different maxima dominate there. But where two maxima
//      are almost equal, as everywhere on a surface of revolution, all corners use the one closest to that of the
//      strongest corner.
#include <fovea/line/seen_vertices.h>
#include <fovea/line/threshold.h>
#include <fovea/line/zero_set.h>

namespace fovea::line {
namespace {

const auto demarcating_curve_parameters = threshold_parameters<ThresholdValues>(
    0.01, 0.5, 2.0, "Change of curvature that a line reaches somewhere, in units of 1 / feature size squared");

constexpr float least_cosine = 0.70710678f;
/// Share of the global maximum from which a local maximum counts as almost equal.
constexpr float tied = 0.9f;

struct Corner {
    vec3 along;  // g
    float bend, strength;
};

Corner corner(const Curvature& c, const DemarcatingOf<float>& d) {
    return {d.g1 * c.e1 + d.g2 * c.e2, d.curvature, d.strength};
}

/// Makes the corners of a triangle use consistent local maxima, close to that of the strongest corner; false if one has
/// none there that is almost as strong as its own.
bool agree(const Fields& fields, const Triangle& t, Corner (&corners)[3]) {
    int most = 0;
    for (int i = 1; i < 3; ++i)
        if (corners[i].strength > corners[most].strength) most = i;
    const vec3 along = corners[most].along;
    for (int i = 0; i < 3; ++i) {
        if (glm::dot(corners[i].along, along) > least_cosine) continue;
        const Curvature& c = fields.curvature[t[i]];
        const Corner other = corner(c, demarcating_near(c, glm::dot(along, c.e1), glm::dot(along, c.e2)));
        if (!(glm::dot(other.along, along) > least_cosine)) return false;
        if (!(other.strength > tied * corners[i].strength)) return false;
        corners[i] = other;
    }
    return glm::dot(corners[0].along, corners[1].along) > least_cosine &&
           glm::dot(corners[1].along, corners[2].along) > least_cosine &&
           glm::dot(corners[2].along, corners[0].along) > least_cosine;
}

Curves find_demarcating_curve(const SurfaceView& seen, const ThresholdValues& values) {
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    const Thresholds thresholds(surface, values, 2);
    const auto strongest = parallel_map<Corner>(surface.vertex_count(), [&](std::size_t v) {
        const Curvature& c = fields->curvature[v];
        return corner(c, demarcating(c));
    });
    const auto sides = triangle_sides(surface);
    return collect_pieces(surface.triangles.size(), [&](Index triangle, Array<CurvePiece>& out) {
        const Triangle& t = surface.triangles[triangle];
        Corner corners[3] = {strongest[t.x], strongest[t.y], strongest[t.z]};
        const auto strong = [&](const Corner& c) { return c.strength > thresholds.low; };
        if (!std::any_of(corners, corners + 3, strong) || !agree(*fields, t, corners)) return;
        const auto at = [&](Index v) -> const Corner& { return corners[corner_of(t, v)]; };
        append_zero(
            surface, *sides, triangle, [&](Index v) { return at(v).bend; },
            [&](Index v) { return at(v).strength - thresholds.low; }, thresholds, out);
    });
}

}  // namespace

extern const LineDefinition demarcating_curve = {
    .name = "demarcating_curve",
    .label = "Demarcating Curve",
    .source = "Kolomenkin, Shimshoni & Tal 2008",
    .description = "Where a valley turns into a ridge: inflections of the strongest change of curvature",
    .scope = Scope::surface,
    .importance = 0.25,
    .parameters = demarcating_curve_parameters,
    .rule = feature_rule(demarcating_curve_parameters, 2, find_demarcating_curve),
    .of_smooth = true,
};

}  // namespace fovea::line
