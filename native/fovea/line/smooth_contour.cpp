// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth contour: the contour of the smooth surface that the mesh approximates, across its triangles. Hertzmann &
// Zorin, "Illustrating Smooth Surfaces", SIGGRAPH 2000, section 4.
// In   normals of the fitted surface (those of the mesh alone are too rough on irregular triangles); its curvature, if
//      hidden parts are removed; the view
// Out  zeros of the interpolated n . v, without the parts behind cusps, where the radial curvature is negative and the
//      surface occludes its own contour (Koenderink, "What does the occluding contour tell us about solid shape?",
//      Perception 1984)
#include <fovea/line/smooth_contour.h>

#include <algorithm>

#include <fovea/line/outlines.h>
#include <fovea/scene/bodies.h>

namespace fovea::line {
namespace {

struct SmoothContour {
    bool end_at_cusps;
};

const Parameters<SmoothContour> smooth_contour_parameters{
    {&SmoothContour::end_at_cusps, "end_at_cusps", "End at Cusps", true,
     "Leave out what a closed surface hides of its own contour behind a cusp"}};

/// Increase of strength per radial curvature times feature size. Strength is clamped to (0, 1], so that noise in the
/// sign does not break a contour.
constexpr float sureness = 20.0f;

/// Parts of a surface that hide their own contours: closed ones of positive volume. Open shells are seen from both
/// sides; of inside-out ones, such as hulls that show their backs as an outline, what would hide is not there.
struct Hiding {
    Array<std::uint8_t> vertices;  ///< per vertex; empty: none
};

Hiding hiding(const Surface& surface) {
    const auto bodies = bodies_of(surface);
    if (std::ranges::find(bodies->outward, 1) == bodies->outward.end()) return {};
    Hiding found{Array<std::uint8_t>(surface.vertex_count(), 0)};
    for (Index t = 0; t < surface.occluding_triangles; ++t)
        if (bodies->outward[bodies->of_facet[surface.triangle_facet[t]]])
            for (int k = 0; k < 3; ++k) found.vertices[surface.triangles[t][k]] = 1;
    return found;
}

/// Null if no part hides its own contour.
std::shared_ptr<const Array<std::uint8_t>> hides_its_own(const Surface& surface) {
    auto found = surface.cache().get<Hiding>(0, [&] { return hiding(surface); });
    return found->vertices.empty() ? nullptr : std::shared_ptr<const Array<std::uint8_t>>(found, &found->vertices);
}

Curves find_to_cusps(const SurfaceView& seen, const SmoothContour& values) {
    if (!values.end_at_cusps) return find_smooth_contour(seen, [](Index) { return 1.0f; });
    return find_smooth_contour(seen, CuspStrength(seen));
}

Selection select_smooth_contour(const Surface& surface, const SmoothContour& values) {
    if (!values.end_at_cusps || !hides_its_own(surface)) return {};
    return {.level = at_cusp, .depth = surely, .reach = at_cusp + surely, .uniform = true};
}

}  // namespace

CuspStrength::CuspStrength(const SurfaceView& seen) : seen_(seen), hides_(hides_its_own(seen.surface)) {
    if (hides_) fields_ = fields_of(seen.surface);
}

float CuspStrength::operator()(Index vertex) const {
    if (!hides_ || !(*hides_)[vertex]) return 1.0f;
    const Curvature& c = fields_->curvature[vertex];
    const float k_r = radial(c, see_vertex(seen_, c, vertex)).curvature;
    return std::clamp(at_cusp + sureness * fields_->feature_size * k_r, 1e-3f, 1.0f);
}

extern const LineDefinition smooth_contour = {
    .name = "smooth_contour",
    .label = "Smooth Contour",
    .source = "Hertzmann & Zorin 2000, section 4; Cole 2009, section 2.2",
    .description = "The contour of the smooth surface that a mesh stands for, across its faces",
    .scope = Scope::view,
    .importance = outline_importance,
    .parameters = smooth_contour_parameters,
    .rule = CurveRule{CurveType::contour, smooth_contour_parameters.of(find_to_cusps),
                      smooth_contour_parameters.of(select_smooth_contour)},
    .outlines = true,
    .usual = true,
    .of_smooth = true,
};

}  // namespace fovea::line
