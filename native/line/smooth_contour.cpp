// Smooth contour: the contour of the surface that the mesh stands for, across its triangles.
// Hertzmann & Zorin, "Illustrating Smooth Surfaces", SIGGRAPH 2000, section 4.
// In   normals of the fitted surface (those of the mesh alone are too rough on irregular triangles), its curvature
//      where hidden parts are left out, the view
// Out  where the interpolated n . v is zero; without the parts behind cusps, where the radial curvature is negative:
//      there the surface hides its own contour (Koenderink, "What does the occluding contour tell us about solid
//      shape?", Perception 1984)
#include "line/smooth_contour.h"

namespace fovea {
namespace {

/// Strength where the radial curvature is zero, and how fast it grows with it, in units of 1 / feature size. Between 0
/// and 1 it says how sure the sign is, so that noise does not break a contour.
constexpr float at_cusp = 0.5f, sureness = 20.0f, surely = 0.1f;

Curves find(const SurfaceView& seen, const Values& values) {
    if (values[0] == 0.0) return find_smooth_contour(seen, [](Index) { return 1.0f; });
    const auto fields = fields_of(seen.surface);
    return find_smooth_contour(seen, [&](Index v) {
        const Curvature& c = fields->curvature[v];
        const float k_r = radial(c, see_vertex(seen, c, v)).curvature;
        return std::clamp(at_cusp + sureness * fields->feature_size * k_r, 1e-3f, 1.0f);
    });
}

Selection select(const Surface&, const Values& values) {
    if (values[0] == 0.0) return {};
    return {.level = at_cusp, .depth = surely, .reach = at_cusp + surely, .uniform = true};
}

}  // namespace

extern const LineDefinition smooth_contour;
const LineDefinition smooth_contour = {
    .name = "smooth_contour",
    .label = "Smooth Contour",
    .source = "Hertzmann & Zorin 2000, section 4; Cole 2009, section 2.2",
    .description = "The contour of the smooth surface that a mesh stands for, across its faces",
    .scope = Scope::view,
    .parameters = {{"end_at_cusps", "End at Cusps", 1, 0, 1, "bool",
                    "Leave out what the surface hides of its own contour behind a cusp; "
                    "not for open surfaces seen from behind"}},
    .on_by_default = false,
    .find = find,
    .select = select,
    .on_smooth_surface = true,
};

}  // namespace fovea
