// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing of chains across triangles, constrained to the surface.
#pragma once

#include <fovea/field/curvature.h>
#include <fovea/path/chain_curves.h>

namespace fovea::path {

struct Smoothing {
    /// Half width of the window that a point's fit uses, in local side lengths.
    double window = 3.0;
    /// Limit of a point's displacement along its side, as a share of the side.
    double tolerance = 0.4;
    int rounds = 2;
};

/// Moves every point of a chain along its triangle side towards the parabola, as a function of arc length, that is the
/// least-squares fit to the chain around it: curves that are parabolic over the window are unchanged, zigzags are
/// removed. Points stay on their sides; ends of open chains and points inside triangles do not move. Strength is
/// averaged over the same window. Linear time in the number of points. Savitzky & Golay, "Smoothing and Differentiation
/// of Data by Simplified Least Squares Procedures", 1964.
void smooth(CurveChains& chains, const Surface& surface, const Smoothing& options = {});

/// Projects points from the sides of triangles onto the smooth surface that the mesh approximates: onto the cubic
/// through the ends of a side that is given by the normals there (of `curvature`, per vertex). The displacement is at
/// most a tenth of the side's length; a side whose normals differ by more than 60 degrees is kept straight, as an edge.
/// Vlachos et al., "Curved PN Triangles", I3D 2001.
///
/// Then moves points freely as `smooth` does along sides, by at most a tenth of the mean side length nearby: errors of
/// estimated normals would make contours visibly uneven.
void lift(CurveChains& chains, const Surface& surface, In<Curvature> curvature);

}  // namespace fovea::path
