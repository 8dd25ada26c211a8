// SPDX-License-Identifier: GPL-3.0-or-later
// Edges that run alongside each other, with faces between them: what bevels and rounded edges are made of.
#pragma once

#include <algorithm>
#include <cmath>

#include <fovea/field/facet_edges.h>

namespace fovea::field {

class Alongside {
   public:
    /// Refers to `edges`.
    explicit Alongside(const FacetEdges& edges)
        : surface_(edges.surface), turn_(edges.turn), of_facet_(edges.of_facet) {}

    /// signed_turn of an edge.
    double turn(Index edge) const { return turn_[edge]; }

    /// Another edge, the distance to it from the middle of the first one, and the facet beyond it.
    struct Next {
        Index edge = none;
        double width = HUGE_VAL;
        Index beyond = none;
    };

    /// The nearest mesh edge alongside `edge`, across its facet `facet`, of those that `is_wanted`: edges in directions
    /// that differ by up to 26 degrees, and not in a row. Faces are looked across edges that turn by less than a
    /// degree, as between the triangles of a face, twice; not out of facets of more than 64 edges. Its `edge` is none
    /// where there is none.
    template <typename IsWanted>
    Next across(Index edge, Index facet, const IsWanted& is_wanted) const {
        Next nearest;
        const dvec3 from = end(edge, 0), along = end(edge, 1) - from;
        look({along, from + 0.5 * along, glm::dot(along, along)}, edge, facet, 2, is_wanted, nearest);
        nearest.width = std::sqrt(nearest.width);
        return nearest;
    }

    /// How far the corners of a facet at an edge are from the edge's line, at most; of facets of many edges, of some.
    double extent(Index edge, Index facet) const {
        const dvec3 from = end(edge, 0), along = end(edge, 1) - from;
        const double length2 = glm::dot(along, along);
        double most = 0.0;
        const In<Index> edges = of_facet_[facet];
        for (std::size_t i = 0; i < edges.size(); i += 1 + edges.size() / most_edges)
            for (const int k : {0, 1}) {
                const dvec3 to = end(edges[i], k) - from;
                const double share = length2 > 0.0 ? glm::dot(to, along) / length2 : 0.0;
                most = std::max(most, glm::length(to - share * along));
            }
        return most;
    }

   private:
    static constexpr double flat = glm::radians(1.0);
    static constexpr double alongside = 0.9;  // cosine of the angle between the two edges
    static constexpr std::size_t most_edges = 64;

    dvec3 end(Index edge, int k) const { return dvec3(surface_.positions[surface_.edges[edge][k]]); }

    /// The edge from which others are looked for.
    struct Start {
        dvec3 along, middle;
        double length2;
    };

    /// Looks among the edges of a facet that was entered by the edge `from`. Of `nearest` the width is squared.
    template <typename IsWanted>
    void look(const Start& start, Index from, Index facet, int flats, const IsWanted& is_wanted, Next& nearest) const {
        const In<Index> edges = of_facet_[facet];
        if (edges.size() > most_edges) return;
        for (const Index other : edges) {
            if (other == from) continue;
            const In<EdgeSide> sides = surface_.sides(other);
            const Index beyond = sides.size() == 2 ? sides[sides[0].facet() == facet ? 1 : 0].facet() : none;
            if (flats > 0 && beyond != none && std::abs(turn_[other]) < flat)
                look(start, other, beyond, flats - 1, is_wanted, nearest);
            if (other < surface_.mesh_edges && is_wanted(other)) {
                const dvec3 origin = end(other, 0), way = end(other, 1) - origin;
                const double length2 = glm::dot(way, way), cosine = glm::dot(start.along, way);
                if (!(cosine * cosine > alongside * alongside * start.length2 * length2)) continue;
                const dvec3 between = start.middle - origin;
                const double share = glm::dot(between, way);
                if (share < 0.0 || share > length2) continue;  // in a row with it, not alongside
                const dvec3 shortest = between - share / length2 * way;
                const double width2 = glm::dot(shortest, shortest);
                if (width2 < nearest.width) nearest = {other, width2, beyond};
            }
        }
    }

    const Surface& surface_;
    const Array<float>& turn_;
    const Lists<Index>& of_facet_;
};

}  // namespace fovea::field
