// SPDX-License-Identifier: GPL-3.0-or-later
// Isophote: lines of equal shading by a headlight.
// Cole 2009, section 2.2.
// In   normals, the view
// Out  level sets of n . v at `count` evenly spaced values in (0, 1]
#include <fovea/line/cluster_trace.h>

namespace fovea::line {
namespace {

struct Isophote {
    int count;
};

const Parameters<Isophote> isophote_parameters{{&Isophote::count, "count", "Count", 10, 1, 100,
                                                "How many lines from the contour, left out, to what faces the viewer"}};

Curves find_isophote(const SurfaceView& seen, const Isophote& values) {
    const auto fields = fields_of(seen.surface);
    const int count = std::max(1, values.count);
    const auto sample = [&](Index v) { return see_vertex(seen, fields->curvature[v], v).facing; };
    const Levels levels{0.0f, 1.0f / float(count), count};
    const auto none_in = [&](const SeenCluster& cluster) { return levels.none_in(cluster.facing()); };
    return trace_levels(seen, none_in, sample, levels);
}

}  // namespace

extern const LineDefinition isophote = {
    .name = "isophote",
    .label = "Isophote",
    .source = "Cole 2009, section 2.2",
    .description = "Lines of equal shading by a lamp at the eye",
    .scope = Scope::view,
    .importance = 0.1,
    .parameters = isophote_parameters,
    .rule = CurveRule{CurveType::level_set, isophote_parameters.of(find_isophote)},
    .slow = true,
};

}  // namespace fovea::line
