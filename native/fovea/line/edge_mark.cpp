// SPDX-License-Identifier: GPL-3.0-or-later
// Edge mark: edges the artist marked by hand.
// Out  mesh edges with a Freestyle mark, and with `seams` those marked as seams
#include <fovea/line/edges.h>

namespace fovea {
namespace {

void trace(const SurfaceView& seen, const Values& values, Kinds bit, Array<Kinds>& kinds) {
    const Surface& surface = seen.surface;
    const int wanted = mark_edge | (values[0] != 0.0 ? mark_seam : 0);
    mark_edges(surface.mesh_edges, bit, kinds,
               [&](Index e) { return (surface.edge_marks[e] & wanted) != 0 && surface.edge_rows.size(e) > 0; });
}

}  // namespace

extern const LineDefinition edge_mark;
const LineDefinition edge_mark = {
    .name = "edge_mark",
    .label = "Edge Mark",
    .source = "Grabli et al. 2010, Programmable Rendering of Line Drawing from 3D Scenes",
    .description = "Edges marked by hand (Freestyle edge marks)",
    .scope = Scope::surface,
    .parameters = {{"seams", "Seams", 0.0, 0.0, 1.0, "bool", "Draw edges marked as UV seams, too"}},
    .on_by_default = true,
    .trace = trace,
};

}  // namespace fovea
