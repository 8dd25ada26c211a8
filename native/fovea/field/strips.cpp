// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/strips.h>

#include <fovea/field/alongside.h>

namespace fovea::field {
namespace {

constexpr double least_turn = glm::radians(15.0), most_turn = glm::radians(65.0);

Array<Index> find(const Surface& surface) {
    const FacetEdges of_facets(surface);
    const Alongside edges(of_facets);
    const auto bends = [&](Index edge) {
        return std::abs(edges.turn(edge)) >= least_turn && std::abs(edges.turn(edge)) <= most_turn;
    };
    return parallel_map<Index>(surface.mesh_edges, [&](std::size_t at) {
        const auto edge = static_cast<Index>(at);
        Alongside::Next nearest;
        if (!bends(edge)) return nearest.edge;
        const Edge& ends = surface.edges[edge];
        nearest.width = glm::distance(dvec3(surface.positions[ends.x]), dvec3(surface.positions[ends.y]));
        for (const EdgeSide side : surface.sides(edge)) {
            const auto next = edges.across(edge, side.facet(), [&](Index other) {
                return bends(other) && edges.turn(other) * edges.turn(edge) > 0.0;
            });
            if (next.width < nearest.width) nearest = next;
        }
        return nearest.edge;
    });
}

}  // namespace

std::shared_ptr<const Array<Index>> strips_of(const Surface& surface) {
    struct Found {
        Array<Index> other;
    };
    const auto found = surface.cache().get<Found>(0, [&] {
        Array<Index> other = find(surface);
        if (std::ranges::all_of(other, [](Index edge) { return edge == none; })) other.clear();
        return Found{std::move(other)};
    });
    return {found, &found->other};
}

}  // namespace fovea::field
