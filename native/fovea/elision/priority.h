// SPDX-License-Identifier: GPL-3.0-or-later
// How important a line is, and who goes before whom. Where lines crowd, the more important one stays (Cole 2009,
// section 5.2.2: there the length of the line in space; Grabli et al. 2004 and Wilson & Ma 2004 ask for what else an
// illustrator weighs).
#pragma once

#include <fovea/base/view.h>
#include <fovea/path/paths.h>
#include <fovea/scene/scene.h>
#include <fovea/style/thinning.h>
#include <fovea/visibility/runs.h>

namespace fovea::elision {

/// Radius of a sphere in space around the placements that are drawn; 0 where there are none.
double scene_radius(const Scene& scene);

/// Priority of each path in [0,1]: the mean of its terms, each weighed as a style says. Terms lie in [0,1], change
/// continuously, and are the same for a scene of any size, whose `radius` is that of a sphere around all that is drawn:
///   length    l / (l + radius / 10) of a path of length l in space: long lines are walls and outlines, short ones
///   details kind      LineDefinition::importance, the mean along the path: outlines before creases before lines on
///   smooth surfaces strength  its mean along the path depth     radius / (radius + d) at mean distance d from the eye
///   along the view: what is near before what is far object    what the caller thinks of each: `object`, per placement
///   in [0,1], may be empty: .5 painted   what the artist has painted, the mean along the path: `painted`, per point of
///   Paths or per path, in [0,1],
///             may be empty: then the term is left out
/// What is not a number counts as 0. Throws std::invalid_argument for arrays of another length, for weights below 0, or
/// all 0.
Array<float> path_priorities(const Paths& paths, const Scene& scene, const View& view, const style::Elision& weights,
                             In<float> object, In<float> painted);

/// Rank of each run, from 1: the higher goes before the lower. Visible runs go before hidden ones; among these, those
/// of paths of higher priority; where that is equal, of lower id, then of lower number. So all visible runs of a path
/// have one rank, all its hidden ones another, and no other path has it. `priority`: per path of Paths; what is not a
/// number comes last. Cole 2009, section 5.2.2.
Array<Index> rank_runs(const ClippedPaths& clipped, const Runs& runs, In<float> priority, In<std::uint64_t> id);

}  // namespace fovea::elision
