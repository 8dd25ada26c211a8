// Silhouette: the outer boundary of an object, against the background or another object.
// Isenberg et al., "A Developer's Guide to Silhouette Algorithms for Polygonal Models", CG&A 2003.
// In   contour and border edges, and the surface seen right behind the middle of each
// Out  those behind which the same placement does not go on
#include "line/edges.h"

namespace fovea {

extern const LineDefinition contour, border;

namespace {

void trace(const SurfaceView& seen, const Values& values, Kinds bit, Array<Kinds>& kinds) {
    const Surface& surface = seen.surface;
    Array<Kinds> candidates(surface.edges.size(), 0);
    contour.trace(seen, values, 1, candidates);
    border.trace(seen, values, 1, candidates);
    mark_edges(surface.edges.size(), bit, kinds, [&](Index e) {
        if (!candidates[e]) return false;
        const Edge edge = surface.edges[e];
        const dvec3 middle = 0.5 * (dvec3(surface.positions[edge.x]) + dvec3(surface.positions[edge.y]));
        const vec3 point(seen.object_to_view * dvec4(middle, 1.0));
        if (!seen.tracer->view().orthographic && point.z >= 0.0f) return false;
        const auto behind = seen.tracer->behind(point, seen.tracer->ignore_at(seen.placement, e));
        return !behind || behind->placement != seen.placement;
    });
}

}  // namespace

extern const LineDefinition silhouette;
const LineDefinition silhouette = {
    .name = "silhouette",
    .label = "Silhouette",
    .source = "Isenberg et al. 2003, A Developer's Guide to Silhouette Algorithms",
    .description = "The outer boundary of an object, against the background or another object",
    .scope = Scope::scene,
    .parameters = {},
    .on_by_default = false,
    .trace = trace,
};

}  // namespace fovea
