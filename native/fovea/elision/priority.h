// SPDX-License-Identifier: GPL-3.0-or-later
// How important a line is. Where lines crowd, the more important one stays (Cole 2009, section 5.2.2: there the length
// of the line in space; Grabli et al. 2004 and Wilson & Ma 2004 ask for what else an illustrator weighs).
#pragma once

#include <fovea/base/view.h>
#include <fovea/path/paths.h>
#include <fovea/scene/scene.h>

namespace fovea {

/// What each term counts for; 0: nothing. Terms lie in [0,1], change continuously, and are the same for a scene of any
/// size. `radius`: that of a sphere around all that is drawn.
struct PriorityWeights {
    /// l / (l + radius / 10) of a path of length l in space: long lines are walls and outlines, short ones details.
    double length = 1.0;
    /// LineDefinition::importance, the mean along the path: outlines before creases before lines on smooth surfaces.
    double kind = 1.0;
    /// Mean strength along the path.
    double strength = 0.25;
    /// radius / (radius + d) at mean distance d from the eye along the view: what is near comes before what is far.
    double depth = 0.25;
    /// The importance of the line's object.
    double object = 1.0;
    /// What the artist has painted, the mean along the path.
    double painted = 1.0;
};

/// Radius of a sphere in space around the placements that are drawn; 0 where there are none.
double scene_radius(const Scene& scene);

/// Priority of each path in [0,1]: the mean of its terms. `object`: per placement in [0,1], may be empty: .5.
/// `painted`: per point of Paths or per path, in [0,1], may be empty: then the term is left out. What is not a number
/// counts as 0. Throws std::invalid_argument for arrays of another length, for weights below 0, or all 0.
Array<float> path_priorities(const Paths& paths, const Scene& scene, const View& view, const PriorityWeights& weights,
                             In<float> object, In<float> painted);

}  // namespace fovea
