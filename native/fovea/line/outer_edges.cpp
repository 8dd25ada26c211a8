// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/outer_edges.h>

#include <algorithm>
#include <cmath>

#include <fovea/line/look_at.h>

namespace fovea::line {
namespace {

constexpr double beside_px = 1.5;  // distance of the second ray from the edge, in reference pixels
constexpr double steepest = 8.0;   // greatest slope towards the viewer of a surface that may continue there

}  // namespace

OuterEdges::OuterEdges(const SurfaceView& seen)
    : seen_(seen),
      view_(seen.tracer->view()),
      clip_to_view_(glm::inverse(view_.view_to_clip)),
      mirrored_(glm::determinant(dmat3(seen.object_to_view)) < 0.0) {}

OuterEdges::Seen OuterEdges::see(Index e) const {
    const Edge edge = seen_.surface.edges[e];
    Seen found{in_view(edge.x), in_view(edge.y), dvec2(0.0), seen_.tracer->ignore_at(seen_.placement, e)};
    const dvec4 clip_a = view_.view_to_clip * found.a, clip_b = view_.view_to_clip * found.b;
    if (clip_a.w <= 0.0 || clip_b.w <= 0.0) return found;
    const dvec2 along = to_pixels(view_, clip_b) - to_pixels(view_, clip_a);
    const double length = glm::length(along);
    if (!(length > 0.0)) return found;
    const dvec2 right = dvec2(along.y, -along.x) / length;
    found.outside = lies_left(e) ? right : -right;
    return found;
}

/// Whether the placement ends at so many reference pixels outside of a place of an edge.
bool OuterEdges::ends_beside(const Seen& edge, const dvec4& place, double px) const {
    const auto outside = [&](double by) {
        return to_pixels(view_, view_.view_to_clip * place) + edge.outside * (by * view_.reference_scale);
    };
    const double away = -place.z,
                 nearer = steepest * glm::distance(dvec2(place), dvec2(beside(outside(beside_px), away)));
    const double before = view_.orthographic ? away - nearer : std::max(away - nearer, 0.1 * away);
    return seen_.ends_at(vec3(beside(outside(px), before)), edge.ignore);
}

bool OuterEdges::ends_at(Index e) const {
    const Seen edge = see(e);
    const dvec4 middle = 0.5 * (edge.a + edge.b);
    if (!view_.orthographic && middle.z >= 0.0) return false;
    if (seen_.ends_at(vec3(middle), edge.ignore)) return true;
    return edge.outside != dvec2(0.0) && ends_beside(edge, middle, beside_px);
}

double OuterEdges::share_outside(Index e, double width_px, int places) const {
    constexpr double spread = 0.6180339887498949;  // golden section: any few places in a row are far apart
    const Seen edge = see(e);
    if (edge.outside == dvec2(0.0)) return 0.0;
    int ending = 0;
    for (int k = 0; k < places; ++k) {
        const double share = (k + 0.5) / places, across = (k + 0.5) * spread;
        const dvec4 place = glm::mix(edge.a, edge.b, share);
        if (!view_.orthographic && place.z >= 0.0) continue;
        ending += ends_beside(edge, place, glm::mix(beside_px, width_px, across - std::floor(across)));
    }
    return double(ending) / places;
}

dvec3 OuterEdges::beside(const dvec2& px, double away) const { return from_pixels(view_, clip_to_view_, px, away); }

dvec4 OuterEdges::in_view(Index vertex) const {
    return seen_.object_to_view * dvec4(dvec3(seen_.surface.positions[vertex]), 1.0);
}

/// Whether the surface is to the left, in the image, of a contour or border edge directed from its first to its
/// second vertex. A front-facing facet that winds along the edge is.
bool OuterEdges::lies_left(Index e) const {
    const EdgeSide side = seen_.surface.edge_sides[seen_.surface.edge_rows.begin(e)];
    const bool facing =
        seen_.facing.empty() ? is_facing(seen_, side.facet(), edge_on_to_viewer) : bool(seen_.facing[side.facet()]);
    return (facing == side.forward()) != mirrored_;
}

}  // namespace fovea::line
