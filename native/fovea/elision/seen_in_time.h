// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility over neighboring frames: how long each place of the lines of the mesh is seen (Cole 2009, 5.4, blurs the
// visibility of consecutive frames, rather than their pixels).
#pragma once

#include <memory>
#include <utility>

#include <fovea/elision/seen_lines.h>
#include <fovea/elision/seen_over_time.h>

namespace fovea::elision {

/// A neighboring frame: its offset in frames (negative: earlier), and its lines.
using SeenNear = std::pair<int, std::shared_ptr<const SeenLines>>;

/// Share of the time, from `frames` frames before this one to as many after it, for which the lines of the mesh are
/// seen (seen_over_time.h), in arc length of this frame's paths: per path; without ramps where nothing changes, and on
/// paths that depend on the view. A place that is not found in a frame, as it is not in that picture or on no line of
/// it, counts there as in the next frame towards this one; so does all in frames that are not given, beyond a cut.
/// Throws std::invalid_argument where an offset is 0 or exceeds `frames`.
std::vector<std::vector<Ramp>> seen_in_time(const Paths& paths, const SeenLines& now, In<SeenNear> near, int frames);

/// The share at each atlas sample; 1 on paths without ramps.
Array<float> seen_at_samples(const ClippedPaths& clipped, const Paths& paths,
                             const std::vector<std::vector<Ramp>>& ramps);

/// Runs whose visible ones, on paths with ramps, are where the share is more than `least`; hidden runs stay where
/// none are visible now.
Runs seen_runs(const ClippedPaths& clipped, const Paths& paths, const Runs& runs,
               const std::vector<std::vector<Ramp>>& ramps, float least);

}  // namespace fovea::elision
