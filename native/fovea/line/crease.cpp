// SPDX-License-Identifier: GPL-3.0-or-later
// Crease: where two faces meet at an angle, and edges marked sharp.
// In   facet normals, sharp marks, shading, the surface's shape (field/shape.h)
// Out  mesh edges whose two facet normals differ by at least `angle`, on hard surfaces where shading is not smooth
//      across them, else where they are folds (line/folds.h); the middle edge of bevels (line/bevels.h) of surfaces
//      that are not smooth; all edges with more than two facets; with `sharp_marks`, also those marked sharp. Never
//      diagonals of polygons.
#include <fovea/line/crease.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <fovea/base/elementary.h>
#include <fovea/field/fields.h>
#include <fovea/field/shape.h>
#include <fovea/field/turn.h>
#include <fovea/line/bevels.h>
#include <fovea/line/edges.h>
#include <fovea/line/folds.h>
#include <fovea/line/registry.h>

namespace fovea::line {
namespace {

struct Crease {
    double angle, length;
    bool sharp_marks;
};

const Parameters<Crease> crease_parameters{
    {&Crease::angle, "angle", "Angle", 30.0, 0.0, 180.0, Unit::degrees,
     "Least angle between the normals of the two faces", Per::object},
    {&Crease::sharp_marks, "sharp_marks", "Sharp Marks", true, "Draw edges marked sharp as creases, too"},
    {&Crease::length, "length", "Length", 6.0, 0.0, 1000.0, Unit::none,
     "Least length of a crease that touches no edge marked sharp, in sizes of the features, on surfaces that are "
     "not hard"}};

Array<Index> find_crease(const SurfaceView& seen, const Crease& values) {
    const Surface& surface = seen.surface;
    const double limit = cosine(glm::radians(values.angle));
    const Shape shape = field::shape_of(surface);
    const bool hard = shape == Shape::hard;
    Array<std::uint8_t> asked(surface.mesh_edges, 0);  // creases if they are folds
    Array<Index> found = parallel_where(surface.mesh_edges, [&](Index e) {
        const In<EdgeSide> sides = surface.sides(e);
        if (sides.size() < 2) return false;
        if (sides.size() > 2 || (values.sharp_marks && (surface.edge_marks[e] & mark_sharp))) return true;
        if (!(field::cosine_at(surface, sides) <= limit + 1e-7)) return false;
        asked[e] = !hard || field::is_shaded_smooth(surface, e);
        return !asked[e];
    });
    const bool any_asked = std::ranges::find(asked, 1) != asked.end();
    if (shape == Shape::smooth && !any_asked) return found;
    const field::FacetEdges edges(surface);
    if (shape != Shape::smooth) {
        Array<std::uint8_t> known(surface.mesh_edges, 0);
        for (const Index e : found) known[e] = 1;
        const Array<std::uint8_t> bevels = find_bevels(edges, values.angle, known);
        found = either(found, parallel_where(surface.mesh_edges, [&](Index e) { return bevels[e] != 0; }));
    }
    if (!any_asked) return found;
    // Fields take long, and most folds are longer than any feature size.
    const double surely_long = values.length * field::greatest_feature_size(surface);
    std::function<bool(double)> is_short;
    if (!hard && values.length > 0.0)
        is_short = [&, size = std::optional<double>()](double length) mutable {
            if (length >= surely_long) return false;
            if (!size) size = field::fields_of(surface)->feature_size;
            return length < values.length * *size;
        };
    const Array<std::uint8_t> folds = find_folds(edges, shape, values.angle, is_short);
    return either(found, parallel_where(surface.mesh_edges, [&](Index e) { return folds[e] != 0; }));
}

}  // namespace

extern const LineDefinition crease = {
    .name = "crease",
    .label = "Crease",
    .source = "Cole 2009, section 2.2; Saito & Takahashi 1990",
    .description = "Where two faces meet at an angle, and edges marked sharp",
    .scope = Scope::surface,
    .importance = 0.5,
    .parameters = crease_parameters,
    .rule = EdgeRule{crease_parameters.of(find_crease)},
    .usual = true,
};

Kinds creases() { return kind_of(crease); }

}  // namespace fovea::line
