// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/turns.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/field/turn.h>

namespace fovea::line {
namespace {

constexpr double flat = glm::radians(1.0);  // edges that turn less are looked across, as between triangles of a face
constexpr int most_flats = 2;               // in a row
constexpr std::size_t most_edges = 64;      // of a facet that is looked out of: edges of larger ones can be very many
constexpr double parallel_cosine = 0.7071;  // of directions that count as parallel

dvec3 vector_of(const Surface& surface, Index edge) {
    const Edge& e = surface.edges[edge];
    return dvec3(surface.positions[e.y]) - dvec3(surface.positions[e.x]);
}

}  // namespace

Turns::Turns(const field::FacetEdges& edges) : surface_(edges.surface), turn_(edges.turn), of_facet_(edges.of_facet) {
    triangles_ = lists_of<Index>(surface_.vertex_count(), [&](const auto& give) {
        for (Index t = 0; t < surface_.triangles.size(); ++t)
            for (int k = 0; k < 3; ++k) give(surface_.triangles[t][k], t);
    });
}

template <typename Of>
double Turns::on_both_sides(Index edge, const Of& of) const {
    const In<EdgeSide> sides = surface_.sides(edge);
    return 0.5 * (of(sides[0].facet()) + of(sides[1].facet()));
}

/// Calls visit(edge, weight) for the edges of a facet without `edge`, and instead of flat ones for what is met across
/// them, up to `flats` in a row. Weights are lengths along `along`, as shares of those of a facet; they sum up to
/// `sum`.
template <typename Visit>
void Turns::meet(Index edge, Index facet, const dvec3& along, double sum, int flats, const Visit& visit) const {
    const auto length = [&](Index e) { return e == edge ? 0.0 : std::abs(glm::dot(vector_of(surface_, e), along)); };
    double whole = 0.0;
    for (const Index e : of_facet_[facet]) whole += length(e);
    if (of_facet_[facet].size() > most_edges) flats = 0;
    for (const Index e : of_facet_[facet]) {
        if (e == edge) continue;
        const double weight = whole > 0.0 ? sum * length(e) / whole : 0.0;
        const In<EdgeSide> sides = surface_.sides(e);
        if (flats > 0 && sides.size() == 2 && std::abs(turn_[e]) < flat)
            meet(e, sides[sides[0].facet() == facet].facet(), along, weight, flats - 1, visit);
        else
            visit(e, weight);
    }
}

double Turns::parallel(Index edge) const {
    const dvec3 along = vector_of(surface_, edge);
    const double sign = turn_[edge] < 0.0f ? -1.0 : 1.0, length = glm::length(along);
    return on_both_sides(edge, [&](Index facet) {
        double most = 0.0;
        meet(edge, facet, along, 1.0, most_flats, [&](Index other, double) {
            if (!(sign * turn_[other] > most)) return;
            const dvec3 vector = vector_of(surface_, other);
            if (std::abs(glm::dot(vector, along)) > parallel_cosine * glm::length(vector) * length)
                most = sign * turn_[other];
        });
        return most;
    });
}

double Turns::alongside(Index edge) const {
    const dvec3 along = vector_of(surface_, edge);
    const double sign = turn_[edge] < 0.0f ? -1.0 : 1.0;
    return on_both_sides(edge, [&](Index facet) {
        double mean = 0.0;
        meet(edge, facet, along, 1.0, most_flats,
             [&](Index other, double weight) { mean += weight * std::max(0.0, sign * turn_[other]); });
        return mean;
    });
}

double Turns::around(Index edge) const {
    const In<EdgeSide> sides = surface_.sides(edge);
    const auto normal = [&](Index facet) { return dvec3(surface_.facet_plane[facet]); };
    const dvec3 first = normal(sides[0].facet()), second = normal(sides[1].facet());
    double sum = 0.0;
    Index count = 0;
    for (const Index v : {surface_.edges[edge].x, surface_.edges[edge].y})
        for (const Index t : triangles_[v]) {
            const dvec3 n = normal(surface_.triangle_facet[t]);
            sum += arc_cosine(std::clamp(std::max(glm::dot(n, first), glm::dot(n, second)), -1.0, 1.0));
            ++count;
        }
    return count ? sum / count : 0.0;
}

}  // namespace fovea::line
