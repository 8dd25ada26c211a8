// SPDX-License-Identifier: GPL-3.0-or-later
// Topographic line: lines of equal view depth, like those of a map.
// Cole 2009, section 2.2.
// In   the view
// Out  level sets of the distance along -z in view space, at `count` evenly spaced values over the surface's depth
#include <fovea/line/cluster_trace.h>

namespace fovea::line {
namespace {

struct Topographic {
    int count;
};

const Parameters<Topographic> topographic_parameters{
    {&Topographic::count, "count", "Count", 20, 1, 200, "How many lines over the depth of the object"}};

Curves find_topographic(const SurfaceView& seen, const Topographic& values) {
    const dmat4& m = seen.object_to_view;
    const auto depth_of = [&](const vec3& p) { return -(m * dvec4(dvec3(p), 1.0)).z; };
    const auto sample = [&](Index v) { return static_cast<float>(depth_of(seen.surface.positions[v])); };
    // The depth range is that of the bounding sphere, so that lines do not move with single vertices.
    const dvec3 row(m[0][2], m[1][2], m[2][2]);
    const double middle = -(glm::dot(row, dvec3(seen.surface.center)) + m[3][2]);
    const double reach = glm::length(row) * seen.surface.radius;
    const int count = std::max(1, values.count);
    const double step = 2.0 * reach / (count + 1);
    const Levels levels{static_cast<float>(middle - reach), static_cast<float>(step), count};
    const auto none_in = [&](const SeenCluster& cluster) {
        const double at = depth_of(cluster.bounds().center), spread = glm::length(row) * cluster.bounds().radius;
        const double wide = spread + 1e-5 * (std::abs(at) + spread);
        return levels.none_in({static_cast<float>(at - wide), static_cast<float>(at + wide)});
    };
    return trace_levels(seen, none_in, sample, levels);
}

}  // namespace

extern const LineDefinition topographic = {
    .name = "topographic",
    .label = "Topographic Line",
    .source = "Cole 2009, section 2.2",
    .description = "Lines of equal distance along the view, like those of a map",
    .scope = Scope::view,
    .importance = 0.1,
    .parameters = topographic_parameters,
    .rule = CurveRule{CurveType::level_set, topographic_parameters.of(find_topographic)},
    .slow = true,
};

}  // namespace fovea::line
