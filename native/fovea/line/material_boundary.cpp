// SPDX-License-Identifier: GPL-3.0-or-later
// Material boundary: where two materials meet on a surface.
// Out  mesh edges between polygons of different materials
#include <algorithm>

#include <fovea/base/parallel.h>
#include <fovea/line/definition.h>

namespace fovea::line {
namespace {

Array<Index> find_material_boundary(const SurfaceView& seen, const Values&) {
    const Surface& surface = seen.surface;
    return parallel_where(surface.mesh_edges, [&](Index e) {
        const In<EdgeSide> sides = surface.sides(e);
        return std::ranges::any_of(
            sides, [&](EdgeSide side) { return surface.material(side.facet()) != surface.material(sides[0].facet()); });
    });
}

}  // namespace

extern const LineDefinition material_boundary = {
    .name = "material_boundary",
    .label = "Material Boundary",
    .source = "Grabli et al. 2010, Programmable Rendering of Line Drawing from 3D Scenes",
    .description = "Where two materials meet on a surface",
    .scope = Scope::surface,
    .importance = 0.4,
    .rule = EdgeRule{find_material_boundary},
    .usual = true,
};

}  // namespace fovea::line
