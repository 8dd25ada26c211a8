// SPDX-License-Identifier: GPL-3.0-or-later
// Contour as mesh edges: where the surface turns away from the viewer. Hertzmann, "Introduction to 3D Silhouette
// Detection and Smoothing", SIGGRAPH 1999 course; Benard & Hertzmann, "Line Drawings from 3D Models: a Tutorial", 2019.
// In   facing per facet
// Out  edges whose facets are all on one side of them in the image. For a consistently oriented pair: one is
//      front-facing and the other back-facing. For inconsistent pairs and for more than two facets the same condition
//      does not depend on orientation. Edges with one facet are borders instead.
#include <algorithm>

#include <fovea/base/parallel.h>
#include <fovea/line/definition.h>
#include <fovea/line/outlines.h>

namespace fovea::line {
namespace {

Array<Index> find_contour(const SurfaceView& seen, const Values&) {
    const Surface& surface = seen.surface;
    return parallel_where(surface.edges.size(), [&](Index e) {
        const In<EdgeSide> sides = surface.sides(e);
        if (sides.size() < 2) return false;
        // A front-facing facet that winds along the edge is to its left in the image.
        const auto left = [&](const EdgeSide& side) { return bool(seen.facing[side.facet()]) == side.forward(); };
        return std::ranges::all_of(sides, [&](EdgeSide side) { return left(side) == left(sides[0]); });
    });
}

}  // namespace

extern const LineDefinition smooth_contour;
extern const LineDefinition contour = {
    .name = "contour",
    .label = "Contour",
    .source = "Cole 2009, section 2.2; Benard & Hertzmann 2019",
    .description =
        "Where a surface turns away from the viewer: edges between front and back faces. Freestyle calls it Silhouette",
    .scope = Scope::view,
    .importance = outline_importance,
    .rule = EdgeRule{find_contour},
    .smooth_twin = &smooth_contour,
    .outlines = true,
    .usual = true,
};

}  // namespace fovea::line
