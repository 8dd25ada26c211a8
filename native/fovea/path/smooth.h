// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing of chains across triangles, on the surface.
#pragma once

#include <fovea/field/curvature.h>
#include <fovea/path/chain_curves.h>

namespace fovea::path {

struct Smoothing {
    /// Half width of the stretch that a point is fitted to, in local edge lengths.
    double window = 3.0;
    /// How far a point may move along the side that it is on, as a share of the side.
    double tolerance = 0.4;
    int rounds = 2;
};

/// Moves every point of a chain along the side that it is on, towards the parabola that fits the chain around it best
/// (by arc length): what is as smooth as a parabola over the window stays where it is, zigzags go. A point stays on its
/// side; ends of open chains, and points inside triangles, stay. Strength is averaged likewise. Linear in the number of
/// points. Savitzky & Golay, "Smoothing and Differentiation of Data by Simplified Least Squares Procedures", 1964.
void smooth(CurveChains& chains, const Surface& surface, const Smoothing& options = {});

/// Puts points on the surface that the mesh stands for, instead of its straight sides: on the cubic through the side's
/// ends with the normals there (of the curvature per vertex). Never farther from the side than a tenth of its length; a
/// side between normals more than 60 degrees apart stays straight: there is an edge. Vlachos et al., "Curved PN
/// Triangles", I3D 2001.
///
/// Then moves points freely as `smooth` does along sides, but by no more than a tenth of the mean side length nearby:
/// an estimated normal is not so exact as the eye that looks along a contour.
void lift(CurveChains& chains, const Surface& surface, In<Curvature> curvature);

}  // namespace fovea::path
