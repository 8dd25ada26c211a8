// SPDX-License-Identifier: GPL-3.0-or-later
// Border: where an open surface ends; and loose edges, which are nothing but an end.
// Out  mesh edges with exactly one facet; with `loose`, also those that belong to no polygon
#include <fovea/line/edges.h>

namespace fovea::line {
namespace {

struct Border {
    bool loose;
};

const Parameters<Border> parameters{{&Border::loose, "loose", "Loose Edges", true,
                                     "Draw edges without faces, too: wires, curves without a bevel, strands as lines"}};

void mark(const SurfaceView& seen, const Border& values, Kinds bit, Array<Kinds>& kinds) {
    const Surface& surface = seen.surface;
    mark_edges(surface.mesh_edges, bit, kinds,
               [&](Index e) { return surface.edge_rows.size(e) == 1 || (values.loose && surface.is_loose(e)); });
}

}  // namespace

extern const LineDefinition border = {
    .name = "border",
    .label = "Border",
    .source = "Cole 2009, section 2.2; Saito & Takahashi 1990",
    .description = "Where an open surface ends: edges with one face, and loose ones with none",
    .scope = Scope::surface,
    .importance = 0.6,
    .parameters = parameters,
    .rule = EdgeRule{parameters.of(mark)},
    .usual = true,
};

}  // namespace fovea::line
