// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility over neighboring frames: how long each place of a line is seen (Cole 2009, 5.4, blurs the visibility of
// consecutive frames, rather than their pixels).
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <fovea/elision/found_places.h>
#include <fovea/elision/seen_lines.h>
#include <fovea/elision/seen_over_time.h>

namespace fovea::elision {

/// A neighboring frame: its offset in frames (negative: earlier), and its lines.
using SeenNear = std::pair<int, std::shared_ptr<const SeenLines>>;

/// The lines of a frame among those of frames near it. Throws std::invalid_argument where an offset is 0 or exceeds
/// `frames`.
class SeenInTime {
   public:
    /// Borrows `paths` and `now`, which are of the same frame.
    SeenInTime(const Paths& paths, const SeenLines& now, In<SeenNear> near, int frames);

    /// Share of the time, from `frames` frames before this one to as many after it, for which lines are seen
    /// (seen_over_time.h), in arc length of this frame's paths: per path; without ramps where nothing changes.
    ///
    /// Lines of the mesh are found by the part of it on which they lie, those of the view by the line nearest to where
    /// the surface went (found_places.h): where they are seen now, by one that is seen there, whatever its definition.
    /// What is not in a picture counts there as in the next frame towards this one; so do places of the mesh that are
    /// on no line of a frame, and all in frames that are not given, beyond a cut. Lines of the view that are on none
    /// come and go: there they are not seen. Of an object most of whose lines are not found, as it moves too far from
    /// one frame to the next, they count as in the next one, too.
    std::vector<std::vector<Ramp>> ramps() const;

    /// What elision leaves of the lines of the view, at places of this frame: its mean over the frames near it in which
    /// a place is seen; 1 where it is in none.
    Array<float> shown_near() const;

   private:
    const Paths& paths_;
    const SeenLines& now_;
    int frames_;
    std::vector<std::shared_ptr<const SeenLines>> there_;  // per moment; null: none
    std::vector<Array<FoundPlace>> found_;                 // per moment
};

/// The share at each atlas sample; 1 on paths without ramps.
Array<float> seen_at_samples(const ClippedPaths& clipped, const Paths& paths,
                             const std::vector<std::vector<Ramp>>& ramps);

/// Runs whose visible ones, on paths with ramps, are where the share is more than `least`; hidden runs stay where
/// none are visible now.
Runs seen_runs(const ClippedPaths& clipped, const Paths& paths, const Runs& runs,
               const std::vector<std::vector<Ramp>>& ramps, float least);

}  // namespace fovea::elision
