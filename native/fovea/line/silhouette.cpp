// SPDX-License-Identifier: GPL-3.0-or-later
// Silhouette: the outer boundary of an object, against the background or another object. Isenberg et al., "A
// Developer's Guide to Silhouette Algorithms for Polygonal Models", CG&A 2003.
// In   contour and border edges; rays through the middle of each, and through a point next to it
// Out  those behind which neither the same placement nor one of its group continues. On coarse meshes, facets seen
//      almost edge-on lie slightly behind one another along a contour: a continuation narrower than a pen is ignored.
#include <fovea/line/edges.h>
#include <fovea/line/outer_edges.h>

namespace fovea::line {

extern const LineDefinition contour, border, smooth_silhouette;

namespace {

const Values without_loose{0.0};  // of border: an edge without a face bounds nothing

void mark(const SurfaceView& seen, const Values& values, Kinds bit, Array<Kinds>& kinds) {
    Array<Kinds> candidates(seen.surface.edges.size(), 0);
    std::get<EdgeRule>(contour.rule).mark(seen, values, 1, candidates);
    std::get<EdgeRule>(border.rule).mark(seen, without_loose, 1, candidates);
    const OuterEdges outer(seen);
    mark_edges(candidates.size(), bit, kinds, [&](Index e) { return candidates[e] && outer.ends_at(e); });
}

}  // namespace

extern const LineDefinition silhouette = {
    .name = "silhouette",
    .label = "Silhouette",
    .source = "Isenberg et al. 2003, A Developer's Guide to Silhouette Algorithms",
    .description =
        "The outer boundary of an object, against the background or another object. Freestyle calls it Contour",
    .scope = Scope::scene,
    .importance = 1.0,
    .rule = EdgeRule{mark, &contour},
    .smooth_twin = &smooth_silhouette,
    .slow = true,
    .stand_ins = {{&contour}, {&border, {{"loose", 0.0}}}},
    .usual = true,
};

}  // namespace fovea::line
