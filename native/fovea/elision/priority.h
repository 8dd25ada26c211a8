// SPDX-License-Identifier: GPL-3.0-or-later
// Priority of paths, and the total order of runs by it. Where lines crowd, the one of higher priority stays (Cole 2009,
// section 5.2.2, where priority is the length of the line in space; Grabli et al. 2004 and Wilson & Ma 2004 discuss
// what else an illustrator weighs).
#pragma once

#include <fovea/base/view.h>
#include <fovea/path/paths.h>
#include <fovea/scene/scene.h>
#include <fovea/style/thinning.h>
#include <fovea/visibility/runs.h>

namespace fovea::elision {

/// Radius of a sphere in space that bounds the drawn placements; 0 if there are none.
double scene_radius(const Scene& scene);

/// Priority of each path in [0,1]: the mean of these terms, weighted by `weights`. Terms lie in [0,1], are continuous,
/// and do not change with the scene's scale: `radius` is that of a sphere that bounds all that is drawn.
/// - length: l / (l + radius / 10) for a path of length l in space; walls and outlines are long, details short.
/// - kind: mean along the path of LineDefinition::importance; outlines before creases before lines on smooth surfaces.
/// - strength: its mean along the path.
/// - depth: radius / (radius + d) at mean distance d from the eye along the view axis; near before far.
/// - object: `object`, per placement in [0,1], set by the caller; may be empty: .5.
/// - painted: mean along the path of `painted`, per point of Paths or per path, in [0,1]; may be empty: no such term.
/// NaN counts as 0. Throws std::invalid_argument for arrays of another length, and for weights below 0 or all 0.
Array<float> path_priorities(const Paths& paths, const Scene& scene, const View& view, const style::Elision& weights,
                             In<float> object, In<float> painted);

/// Rank of each run, from 1; higher ranks take precedence. Visible runs rank above hidden ones; within these, by
/// priority of their path, then lower id, then lower path number. So all visible runs of a path share one rank, all its
/// hidden ones another, and no other path has either. `priority`: per path of Paths; NaN ranks lowest. Cole 2009,
/// section 5.2.2.
Array<Index> rank_runs(const ClippedPaths& clipped, const Runs& runs, In<float> priority, In<std::uint64_t> id);

}  // namespace fovea::elision
