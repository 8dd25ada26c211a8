// SPDX-License-Identifier: GPL-3.0-or-later
// Projection and clipping of paths, and layout of their samples in the segment atlas.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/paths.h>
#include <fovea/project/clipped_paths.h>

namespace fovea::project {

/// Lower bound of sample_step_px, which limits memory.
inline constexpr double least_sample_step_px = 1e-3;

struct ProjectOptions {
    /// Pixels between samples (k of eq. 5.1): l = ceil(length / k).
    double sample_step_px = 2.0;
    /// Margin around the frame, as a fraction of its half size, so that clipped ends of strokes lie out of view.
    double margin = 0.1;
    /// Per line set: minimum length in the image. Shorter paths with an end that touches no other line are dropped; so
    /// are closed contours up to twice as long that enclose almost no area and touch no other contour, and closed
    /// intersections a third as long: tips that poke through a surface. Empty: nothing is dropped.
    std::vector<double> least_length_px{};
};

/// Clips paths in homogeneous coordinates at the near plane, the section plane and the widened frame, projects them,
/// measures arc length over the whole path (zero at its middle in space) and lays out their samples contiguously. A
/// path of one segment no longer than a sample is dropped. Cole 2009, section 5.1.2, "Projection and Clipping".
ClippedPaths project(const Paths& paths, const Scene& scene, const View& view, const ProjectOptions& options,
                     const Cancel& cancel);

}  // namespace fovea::project
