// SPDX-License-Identifier: GPL-3.0-or-later
// Silhouette: the outer boundary of an object, against the background or another object. Isenberg et al., "A
// Developer's Guide to Silhouette Algorithms for Polygonal Models", CG&A 2003.
// In   contour and border edges; rays through the middle of each, and through a point next to it
// Out  those behind which neither the same placement nor one of its group continues. On coarse meshes, facets seen
//      almost edge-on lie slightly behind one another along a contour: a continuation narrower than a pen is ignored.
#include <algorithm>

#include <fovea/base/parallel.h>
#include <fovea/line/definition.h>
#include <fovea/line/edges.h>
#include <fovea/line/outlines.h>

namespace fovea::line {

extern const LineDefinition contour, border, smooth_silhouette;

namespace {

constexpr double beside_px = 1.5;  // distance of the second ray from the edge, in reference pixels
constexpr double steepest = 8.0;   // greatest slope towards the viewer of a surface that may continue there
const Values without_loose{0.0};   // of border: an edge without a face bounds nothing

/// Tests what is behind the edges of one placement.
class Beyond {
   public:
    explicit Beyond(const SurfaceView& seen)
        : seen_(seen),
          view_(seen.tracer->view()),
          clip_to_view_(glm::inverse(view_.view_to_clip)),
          mirrored_(glm::determinant(dmat3(seen.object_to_view)) < 0.0) {}

    /// Whether the placement ends at an edge, in the image.
    bool is_outer(Index e) const {
        const Edge edge = seen_.surface.edges[e];
        const dvec4 a = in_view(edge.x), b = in_view(edge.y), middle = 0.5 * (a + b);
        if (!view_.orthographic && middle.z >= 0.0) return false;
        const Ignore ignore = seen_.tracer->ignore_at(seen_.placement, e);
        if (seen_.ends_at(vec3(middle), ignore)) return true;
        const dvec4 clip_a = view_.view_to_clip * a, clip_b = view_.view_to_clip * b;
        if (clip_a.w <= 0.0 || clip_b.w <= 0.0) return false;
        const dvec2 along = to_pixels(view_, clip_b) - to_pixels(view_, clip_a);
        const double length = glm::length(along);
        if (!(length > 0.0)) return false;
        const dvec2 right = dvec2(along.y, -along.x) * (beside_px * view_.reference_scale / length);
        const dvec2 px = to_pixels(view_, view_.view_to_clip * middle) + (lies_left(e) ? right : -right);
        const double away = -middle.z, nearer = steepest * glm::distance(dvec2(middle), dvec2(beside(px, away)));
        const double before = view_.orthographic ? away - nearer : std::max(away - nearer, 0.1 * away);
        return seen_.ends_at(vec3(beside(px, before)), ignore);
    }

   private:
    dvec3 beside(const dvec2& px, double away) const { return from_pixels(view_, clip_to_view_, px, away); }

    dvec4 in_view(Index vertex) const {
        return seen_.object_to_view * dvec4(dvec3(seen_.surface.positions[vertex]), 1.0);
    }

    /// Whether the surface is to the left, in the image, of a contour or border edge directed from its first to its
    /// second vertex. A front-facing facet that winds along the edge is.
    bool lies_left(Index e) const {
        const EdgeSide side = seen_.surface.edge_sides[seen_.surface.edge_rows.begin(e)];
        return (bool(seen_.facing[side.facet()]) == side.forward()) != mirrored_;
    }

    const SurfaceView& seen_;
    const View& view_;
    const dmat4 clip_to_view_;
    const bool mirrored_;
};

Array<Index> find_silhouette(const SurfaceView& seen, const Values& values) {
    const Array<Index> candidates = either(std::get<EdgeRule>(contour.rule).find(seen, values),
                                           std::get<EdgeRule>(border.rule).find(seen, without_loose));
    const Beyond beyond(seen);
    return parallel_filter(candidates, 256, [&](Index e) { return beyond.is_outer(e); });
}

}  // namespace

extern const LineDefinition silhouette = {
    .name = "silhouette",
    .label = "Silhouette",
    .source = "Isenberg et al. 2003, A Developer's Guide to Silhouette Algorithms",
    .description =
        "The outer boundary of an object, against the background or another object. Freestyle calls it Contour",
    .scope = Scope::scene,
    .importance = outline_importance,
    .rule = EdgeRule{find_silhouette, &contour},
    .smooth_twin = &smooth_silhouette,
    .slow = true,
    .stand_ins = {{&contour}, {&border, {{"loose", 0.0}}}},
    .usual = true,
};

}  // namespace fovea::line
