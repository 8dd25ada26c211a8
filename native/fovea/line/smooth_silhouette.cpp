// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth silhouette: the outer boundary of an object, on the contour of the smooth surface. Isenberg et al., "A
// Developer's Guide to Silhouette Algorithms for Polygonal Models", CG&A 2003; contours as in Hertzmann & Zorin,
// "Illustrating Smooth Surfaces", SIGGRAPH 2000.
// In   the smooth contour; a ray next to the middle of each of its pieces
// Out  the pieces behind which neither the same placement nor one of its group continues, and which a closed surface
//      does not surely hide itself, as it does the contour of its inside
#include <fovea/line/outlines.h>
#include <fovea/line/smooth_contour.h>

namespace fovea::line {
namespace {

bool is_outer(const SurfaceView& seen, const CurvePiece& piece) {
    const dvec3 middle = 0.5 * (dvec3(piece.point[0]) + dvec3(piece.point[1]));
    const auto own = seen.tracer->ignore_at(seen.placement, seen.surface.place_of_triangle(piece.triangle), none, true);
    const vec3 point = vec3(seen.object_to_view * dvec4(middle, 1.0)) + own.above;
    if (!seen.tracer->view().orthographic && point.z >= 0.0f) return false;
    return seen.ends_at(point, own);
}

Curves find_smooth_silhouette(const SurfaceView& seen, const Values&) {
    Curves pieces = find_smooth_contour(seen, CuspStrength(seen));
    parallel_for(pieces.size(), 64, [&](std::size_t i) {
        const bool hidden = std::min(pieces[i].strength[0], pieces[i].strength[1]) < at_cusp - surely;
        const float strength = !hidden && is_outer(seen, pieces[i]) ? 1.0f : 0.0f;
        pieces[i].strength[0] = pieces[i].strength[1] = strength;
    });
    return pieces;
}

/// Cuts at whole segments where strength, smoothed along the contour (path/smooth.h), is below 0.5: single wrong rays
/// are outvoted.
Selection select_smooth_silhouette(const Surface&, const Values&) {
    return {.level = 0.5f, .reach = 0.5f, .whole = true, .uniform = true};
}

}  // namespace

extern const LineDefinition smooth_contour;
extern const LineDefinition smooth_silhouette = {
    .name = "smooth_silhouette",
    .label = "Smooth Silhouette",
    .source = "Isenberg et al. 2003; Hertzmann & Zorin 2000, section 4",
    .description =
        "The outer boundary of the smooth surface that a mesh stands for, "
        "against the background or another object",
    .scope = Scope::scene,
    .importance = outline_importance,
    .rule = CurveRule{CurveType::contour, find_smooth_silhouette, select_smooth_silhouette, &smooth_contour},
    .slow = true,
    .stand_ins = {{&smooth_contour, {{"end_at_cusps", 0.0}}}},
    .of_smooth = true,
};

}  // namespace fovea::line
