// SPDX-License-Identifier: GPL-3.0-or-later
// Paths from plain polylines in view space: a mesh of edges without polygons, seen by a camera at the origin.
#pragma once

#include "drawing.h"

namespace fovea::wires {
using namespace draw;

/// Looks along -z; half the frame's width and height at distance 1 are 0.8 and 0.6.
View camera(double near_clip = 0.1, bool orthographic = false);

/// The part of a camera's image that a render border leaves: pixels x0 .. x1, y0 .. y1.
View cropped(const View& view, int x0, int y0, int x1, int y1);

/// Polylines as paths of placement 0; a polyline whose last point equals its first is closed. Other placements may
/// stand before them.
struct Wires {
    Scene scene;
    Paths paths;

    explicit Wires(const std::vector<std::vector<dvec3>>& lines, dmat4 object_to_world = dmat4(1.0),
                   const std::vector<Placement>& others = {});

    ClippedPaths project(const View& view, const ProjectOptions& options = {}) const;
};

/// The polyline projected by itself.
ClippedPaths project_line(const std::vector<dvec3>& line, const View& view, const ProjectOptions& options = {});

Index first_of(const ClippedPaths& clipped, Index piece);
Index last_of(const ClippedPaths& clipped, Index piece);

}  // namespace fovea::wires
