// SPDX-License-Identifier: GPL-3.0-or-later
// Border: where an open surface ends.
// Out  mesh edges with exactly one facet
#include <fovea/line/edges.h>

namespace fovea::line {
namespace {

void mark(const SurfaceView& seen, const Values&, Kinds bit, Array<Kinds>& kinds) {
    const Surface& surface = seen.surface;
    mark_edges(surface.mesh_edges, bit, kinds, [&](Index e) { return surface.edge_rows.size(e) == 1; });
}

}  // namespace

extern const LineDefinition border = {
    .name = "border",
    .label = "Border",
    .source = "Cole 2009, section 2.2; Saito & Takahashi 1990",
    .description = "Where an open surface ends: edges with one face",
    .scope = Scope::surface,
    .importance = 0.6,
    .rule = EdgeRule{mark},
    .usual = true,
};

}  // namespace fovea::line
