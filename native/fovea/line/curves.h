// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that cross triangles: the pieces that field definitions find, one triangle at a time.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::line {

/// A straight piece of a curve in one triangle. An end on a side of the triangle carries the side's number
/// (mesh/triangle_sides.h), which the piece beyond the side shares; an end inside has `none`: there the curve ends.
/// A definition leaves at most one piece of a level in a triangle.
struct CurvePiece {
    Index triangle;
    Index side[2];
    vec3 point[2];       ///< in the surface's space
    float strength[2];   ///< in [0, 1]
    Index level = 0;     ///< pieces of other levels are other curves, though they cross the same sides
    Index other = none;  ///< of a line on two surfaces: the triangle of the second
};

using Curves = Array<CurvePiece>;

/// Which stretches of chained pieces are lines: hysteresis, asked of a whole stretch. Lengths are in object units.
/// Canny, "A Computational Approach to Edge Detection", PAMI 1986; integrals along lines as in Ohtake et al. 2004 and
/// Yoshizawa, Belyaev & Seidel, "Fast and Robust Detection of Crest Lines on Meshes", SPM 2005.
struct Selection {
    float level = 0.0f;    ///< chains are cut where their strength is below it; 0: nowhere
    float depth = 0.0f;    ///< but only through gaps that somewhere go deeper below the level than this
    float reach = 0.0f;    ///< a stretch stays when its strength somewhere is at least this,
    double least = 0.0;    ///< and over its length sums up to at least this much of it: a longer one may be weaker
    bool whole = false;    ///< cut at points of the chain, else between them
    bool uniform = false;  ///< what stays has full strength; else its own
};

/// Curves of the scene that are cached over frames, with what is derived from them.
struct KeptCurves {
    Curves pieces;
    mutable Cache derived;
};

/// Curves of a placement that lie on another one, too (or on itself again). `side` of their pieces is an id
/// chosen by the definition, per set of curves: pieces with equal ids are joined.
struct SceneCurves {
    Index placement, other;
    std::shared_ptr<const KeptCurves> curves;
};

}  // namespace fovea::line
