// Smooth contour: the contour of the surface that the mesh stands for, across its triangles.
// Hertzmann & Zorin, "Illustrating Smooth Surfaces", SIGGRAPH 2000, section 4.
// In   vertex normals
// Out  where the interpolated n . v is zero
#include "field/normals.h"
#include "line/zero_set.h"
#include "line/definition.h"

namespace fovea {
namespace {

Curves find(const SurfaceView& seen, const Values&) {
    const auto normals = vertex_normals(seen.surface);
    Array<float> facing(seen.surface.vertex_count());
    parallel_for(facing.size(), [&](std::size_t v) {
        facing[v] = glm::dot((*normals)[v], seen.to_viewer(static_cast<Index>(v)));
    });
    const auto all = [](Index) { return true; };
    const auto always = [](Index) { return 1.0f; };
    return trace_zero_set(seen.surface, all, [&](Index v) { return facing[v]; }, always, [](float) { return 1.0f; });
}

}  // namespace

extern const LineDefinition smooth_contour;
const LineDefinition smooth_contour = {
    .name = "smooth_contour",
    .label = "Smooth Contour",
    .source = "Hertzmann & Zorin 2000, section 4; Cole 2009, section 2.2",
    .description = "The contour of the smooth surface that a mesh stands for, across its faces",
    .scope = Scope::view,
    .parameters = {},
    .on_by_default = false,
    .find = find,
};

}  // namespace fovea
