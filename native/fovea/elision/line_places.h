// SPDX-License-Identifier: GPL-3.0-or-later
// Places on lines of the mesh, which are found again in other frames: view-independent lines lie at the same places of
// their meshes in every frame.
#pragma once

#include <optional>

#include <fovea/elision/line_parts.h>
#include <fovea/visibility/runs.h>

namespace fovea::elision {

/// Atlas samples of the runs of one frame that are view-independent (those of paths without Paths::of_view).
struct LinePlaces {
    struct Sample {
        Index number;  ///< atlas index
        Index part;    ///< index into `parts`
        double share;  ///< fraction in [0,1] of what the part's key denotes
        double arc;    ///< length from the path's start, object units; ascending along a stretch
        double reach;  ///< range before and after it in which the sample is valid, object units
        bool inside;   ///< of the picture
    };

    Array<LinePart> parts;  ///< by key
    /// Per stretch (one per run): its path, ascending; whether it is hidden; its samples.
    Array<Index> path;
    Array<std::uint8_t> hidden;
    Rows rows;
    Array<Sample> samples;
};

/// `width`, `height`: of the picture [px].
LinePlaces line_places(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const Runs& runs, int width,
                       int height);

/// The places of one frame's lines among another's. Of a frame beyond a cut nothing is to be matched.
class MatchedPlaces {
   public:
    /// Borrows `there`.
    MatchedPlaces(const LinePlaces& now, const LinePlaces& there);

    /// A place between two samples (indices into LinePlaces::samples) of the same stretch, or at one, which is both:
    /// its share of the way from the one before to the one after it.
    struct Place {
        Index before, after;
        double share;
    };
    /// Where a sample of `now` is in the other frame, on a stretch that is hidden, or one that is not; none where it is
    /// on no such stretch, or outside of that picture.
    std::optional<Place> at(const LinePlaces::Sample& sample, bool hidden) const;

   private:
    std::optional<Place> on(Index stretch, double arc) const;

    const LinePlaces& there_;
    Array<Index> part_;           // per part of `now`: the part of `there` with its key; none unless there is one
    Array<Index> first_stretch_;  // of `there`, per path, and one more
};

}  // namespace fovea::elision
