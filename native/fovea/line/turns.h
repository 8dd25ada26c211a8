// SPDX-License-Identifier: GPL-3.0-or-later
// How much a surface turns at its edges, and beside them: what a fold is measured against.
#pragma once

#include <fovea/field/facet_edges.h>

namespace fovea::line {

/// Turns in radians. What lies beside an edge is met on leaving either of its facets over another edge; edges that turn
/// by less than a degree, as the diagonals of a face, are looked across, but not out of facets of more than 64 edges.
/// Turns the other way count as none there.
class Turns {
   public:
    /// Refers to `edges`.
    explicit Turns(const field::FacetEdges& edges);

    /// At an edge; negative where the surface is concave, 0 where there are not two facets.
    double operator[](Index edge) const { return turn_[edge]; }

    /// The greatest turn among the next edges that are parallel to an edge with two facets; mean over its sides.
    double parallel(Index edge) const;

    /// The mean turn at the next edges, weighted by their lengths along an edge with two facets: as large as at the
    /// edge itself within a regular bowl, tube or sphere, half as large at its rim; mean over its sides.
    double alongside(Index edge) const;

    /// Mean angle between the triangles around both ends of an edge with two facets and whichever of these is closer in
    /// direction.
    double around(Index edge) const;

   private:
    template <typename Of>
    double on_both_sides(Index edge, const Of& of) const;
    template <typename Visit>
    void meet(Index edge, Index facet, const dvec3& along, double sum, int flats, const Visit& visit) const;

    const Surface& surface_;
    const Array<float>& turn_;
    const Lists<Index>& of_facet_;
    Lists<Index> triangles_;  // around each vertex
};

}  // namespace fovea::line
