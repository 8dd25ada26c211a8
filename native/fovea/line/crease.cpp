// SPDX-License-Identifier: GPL-3.0-or-later
// Crease: where two faces meet at an angle, and edges marked sharp.
// In   facet normals, sharp marks
// Out  mesh edges whose two facet normals differ by at least `angle`; all edges with more than two facets; with
//      `sharp_marks`, also those marked sharp. Never diagonals of polygons.
#include <cmath>

#include <fovea/line/edges.h>

namespace fovea::line {
namespace {

struct Crease {
    double angle;
    bool sharp_marks;
};

const Parameters<Crease> parameters{
    {&Crease::angle, "angle", "Angle", 30.0, 0.0, 180.0, Unit::degrees,
     "Least angle between the normals of the two faces", Per::object},
    {&Crease::sharp_marks, "sharp_marks", "Sharp Marks", true, "Draw edges marked sharp as creases, too"}};

void mark(const SurfaceView& seen, const Crease& values, Kinds bit, Array<Kinds>& kinds) {
    const Surface& surface = seen.surface;
    const auto limit = static_cast<float>(std::cos(glm::radians(values.angle)));
    mark_edges(surface.mesh_edges, bit, kinds, [&](Index e) {
        const In<EdgeSide> sides = surface.sides(e);
        if (sides.size() < 2) return false;
        if (sides.size() > 2 || (values.sharp_marks && (surface.edge_marks[e] & mark_sharp))) return true;
        const EdgeSide a = sides[0], b = sides[1];
        const vec3 na(surface.facet_plane[a.facet()]), nb(surface.facet_plane[b.facet()]);
        // If the two facets have opposite orientation, negate one normal.
        const float cosine = a.forward() == b.forward() ? -glm::dot(na, nb) : glm::dot(na, nb);
        return cosine <= limit;
    });
}

}  // namespace

extern const LineDefinition crease = {
    .name = "crease",
    .label = "Crease",
    .source = "Cole 2009, section 2.2; Saito & Takahashi 1990",
    .description = "Where two faces meet at an angle, and edges marked sharp",
    .scope = Scope::surface,
    .importance = 0.5,
    .parameters = parameters,
    .rule = EdgeRule{parameters.of(mark)},
    .usual = true,
};

}  // namespace fovea::line
