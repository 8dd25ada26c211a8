// SPDX-License-Identifier: GPL-3.0-or-later
// Border: where an open surface ends; and loose edges, which are nothing but an end.
// Out  mesh edges with exactly one facet; with `loose`, also those that belong to no polygon
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/line/definition.h>

namespace fovea::line {
namespace {

struct Border {
    bool loose;
};

const Parameters<Border> border_parameters{
    {&Border::loose, "loose", "Loose Edges", true,
     "Draw edges without faces, too: wires, curves without a bevel, strands as lines"}};

/// Whether an edge has a length: of a loose one, no face has told whether its vertices are broken.
bool has_length(const Surface& surface, const Edge& edge) {
    const dvec3 along = dvec3(surface.positions[edge.y]) - dvec3(surface.positions[edge.x]);
    const double square = glm::dot(along, along);
    return square > 0.0 && std::isfinite(square);
}

Array<Index> find_border(const SurfaceView& seen, const Border& values) {
    const Surface& surface = seen.surface;
    return parallel_where(surface.mesh_edges, [&](Index e) {
        if (surface.edge_rows.size(e) == 1) return true;
        return values.loose && surface.is_loose(e) && has_length(surface, surface.edges[e]);
    });
}

}  // namespace

extern const LineDefinition border = {
    .name = "border",
    .label = "Border",
    .source = "Cole 2009, section 2.2; Saito & Takahashi 1990",
    .description = "Where an open surface ends: edges with one face, and loose ones with none",
    .scope = Scope::surface,
    .importance = 0.6,
    .parameters = border_parameters,
    .rule = EdgeRule{border_parameters.of(find_border)},
    .usual = true,
};

}  // namespace fovea::line
