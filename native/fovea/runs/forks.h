// SPDX-License-Identifier: GPL-3.0-or-later
// Contours along mesh edges of rounded surfaces fork where they end: there they zigzag over the last few facets, and
// what is seen of the zigzag looks like arms of a fork.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/scene/scene.h>
#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// Lengths in pixels.
struct ForkOptions {
    double least;  ///< shorter arms are removed
    double most;   ///< longer ones never are; between them those that are not longer than two of their mesh edges
    double touch;  ///< distance within which runs meet, and outside of which an end is free
};

/// Where an end of a contour along mesh edges meets others of its placement, no farther before or behind it than four
/// of its mesh edges are long, two branches stay: those that go on to something else, where two that leave in the same
/// direction count once, then the longest. Of the others those are removed that end freely, are short, and have no edge
/// at which the surface turns by 50 degrees or more. Lines of the surface, and smooth contours, stay as they are.
/// `visible`: runs of invisibility 0.
Runs without_forks(const ClippedPaths& clipped, const Runs& visible, const Paths& paths, const Scene& scene,
                   const ForkOptions& options);

}  // namespace fovea::runs
