// SPDX-License-Identifier: GPL-3.0-or-later
// Evenly spaced curves over a surface, in levels: those of a coarser one are among those of each finer one.
#pragma once

#include <memory>
#include <vector>

#include <fovea/mesh/surface.h>

namespace fovea::line {

/// A straight part of a curve across a triangle. A curve crosses a triangle at most once.
struct StreamChord {
    Index curve;
    int power;  ///< curves of this power and of higher ones are about 2^power apart
    /// Of its ends: barycentric coordinates, and the side of the triangle that they lie on (side i runs from corner i
    /// to corner i + 1), or -1 where a curve ends inside. Triangles at a side have the same coordinates there.
    vec3 weight[2];
    std::int8_t side[2];
};

/// Per triangle of the surface.
using Streamlines = Lists<StreamChord>;

}  // namespace fovea::line

/// Of three families, as they are near the eye and farther away.
template <>
inline constexpr int fovea::base::kept_of<fovea::line::Streamlines> = 12;

namespace fovea::line {

/// Per angle [radians], counterclockwise as seen from outside, to the directions of greatest curvature
/// (field/bend_directions.h): curves 2^power apart and coarser, in the rest shape if the surface has one. Each grows
/// from a place beside one that is there already until it comes near another one (Jobard & Lefer, "Creating
/// Evenly-Spaced Streamlines of Arbitrary Density", Visualization in Scientific Computing 1997). A power for which
/// there would be too many is raised. Those of each angle are cached with the surface.
std::vector<std::shared_ptr<const Streamlines>> streamlines(const Surface& surface, In<double> angles, int power);

}  // namespace fovea::line
