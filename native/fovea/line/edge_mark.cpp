// SPDX-License-Identifier: GPL-3.0-or-later
// Edge mark: edges marked by hand.
// Out  mesh edges with a Freestyle mark; with `seams`, also those marked as seams
#include <fovea/base/parallel.h>
#include <fovea/line/definition.h>

namespace fovea::line {
namespace {

struct EdgeMark {
    bool seams;
};

const Parameters<EdgeMark> edge_mark_parameters{
    {&EdgeMark::seams, "seams", "Seams", false, "Draw edges marked as UV seams, too"}};

Array<Index> find_marked(const SurfaceView& seen, const EdgeMark& values) {
    const Surface& surface = seen.surface;
    const int wanted = mark_edge | (values.seams ? mark_seam : 0);
    return parallel_where(surface.mesh_edges, [&](Index e) {
        return (surface.edge_marks[e] & wanted) != 0 && surface.edge_rows.size(e) > 0;
    });
}

}  // namespace

extern const LineDefinition edge_mark = {
    .name = "edge_mark",
    .label = "Edge Mark",
    .source = "Grabli et al. 2010, Programmable Rendering of Line Drawing from 3D Scenes",
    .description = "Edges marked by hand (Freestyle edge marks)",
    .scope = Scope::surface,
    .importance = 0.65,
    .parameters = edge_mark_parameters,
    .rule = EdgeRule{edge_mark_parameters.of(find_marked)},
    .reads_edge_marks = true,
    .usual = true,
};

}  // namespace fovea::line
