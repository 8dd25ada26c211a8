// SPDX-License-Identifier: GPL-3.0-or-later
// Polylines as few lines and cubics, within a bound that is checked. What runs straight becomes a line; corners are
// kept; between them cubics join smoothly, each as long as the bound lets it be.
#pragma once

#include <fovea/vector/curve.h>

namespace fovea::vector {

/// A curve from the first to the last of `points`, of which those that are not finite are left out. Every point of the
/// polyline is within `tolerance` of the curve, and every point of the curve within that of the polyline. `closed`: the
/// last point repeats the first. A corner is a turn of more than 30 degrees within a few tolerances, or one between
/// sides so long that no smooth curve keeps within the bound there. Fewer than two distinct points: no curve.
/// `tolerance` 0: lines through all points.
Curve fit(In<dvec2> points, bool closed, double tolerance);

}  // namespace fovea::vector
