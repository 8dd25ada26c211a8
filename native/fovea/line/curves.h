// SPDX-License-Identifier: GPL-3.0-or-later
// Lines across triangles: segments found per triangle by field definitions.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::line {

/// A straight segment of a curve in one triangle. An end on a side of the triangle has the side's number
/// (mesh/triangle_sides.h), which the segment in the adjacent triangle shares; an end inside the triangle has `none`:
/// the curve ends there. A definition yields at most one segment per level in a triangle.
struct CurvePiece {
    Index triangle;
    Index side[2];
    vec3 point[2];      ///< in the surface's space
    float strength[2];  ///< in [0, 1]
    Index level = 0;    ///< segments of different levels belong to different curves, even if they cross the same sides
    /// For a line on two surfaces: the triangle of the second. Or its own triangle, where that is meant as it is: rays
    /// to the line then ignore its facet alone.
    Index other = none;
    /// Of lines that are not told apart by their triangles: from which ids are hashed, unique per piece. 0: of others.
    std::uint64_t key = 0;
};

using Curves = Array<CurvePiece>;

/// Hysteresis thresholds that select intervals of chained segments. Lengths in object units. Canny, "A Computational
/// Approach to Edge Detection", PAMI 1986; integrals along lines as in Ohtake et al. 2004 and Yoshizawa, Belyaev &
/// Seidel, "Fast and Robust Detection of Crest Lines on Meshes", SPM 2005.
struct Selection {
    float level = 0.0f;  ///< chains are cut where their strength is below this; 0: nowhere
    float depth = 0.0f;  ///< only gaps whose minimum strength is below level - depth are cut
    float reach = 0.0f;  ///< intervals whose maximum strength is below this are dropped
    /// Length: an interval is dropped if its strength, integrated over its length, is below least * reach. So stronger
    /// intervals may be shorter.
    double least = 0.0;
    bool whole = false;    ///< cut at points of the chain, else at interpolated crossings of the level
    bool uniform = false;  ///< selected intervals get strength 1, else keep theirs
};

/// Curves of a scene that are cached across frames, with quantities derived from them.
struct KeptCurves {
    Curves pieces;
    mutable Cache derived;
};

/// Curves on a placement that lie on another one, too (or on the same one again). The `side` of their segments is a
/// connection id chosen by the definition, unique within this set of curves: ends with equal ids are joined.
struct SceneCurves {
    Index placement, other;
    std::shared_ptr<const KeptCurves> curves;
};

}  // namespace fovea::line
