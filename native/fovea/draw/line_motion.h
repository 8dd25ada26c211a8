// SPDX-License-Identifier: GPL-3.0-or-later
// How lines move in the image from frame to frame, for blurring pictures of them afterwards.
#pragma once

#include <memory>

#include <fovea/scene/pose.h>

namespace fovea::draw {

class Frame;

/// Motion of a frame's lines between the poses of the frames beside it, Job::before and Job::after.
class LineMotion {
   public:
    /// Borrows.
    explicit LineMotion(const Frame& frame);

    /// At an arc length of a piece, clamped to its ends: where it was in the frame before, from where it is, in x and
    /// y; and where it is, from where it will be, in z and w [px], as Blender's Vector pass has them. Lines move as the
    /// points of the surface on which they lie, those of the view (Paths::of_view) by the part across the line: the
    /// tangent plane of a contour contains the ray to the eye, so that this is the contour's own motion across itself
    /// (Cipolla & Giblin, "Visual Motion of Curves and Surfaces", 2000). 0 towards a frame in which the
    /// object or the point is not there; lines found in the image do not move.
    vec4 at(Index piece, double arc) const;

   private:
    struct Beside {
        std::shared_ptr<const Pose> pose;
        Array<Index> number;  // of the frame's own placed things among its; `none`: it is not there
    };

    const Frame& frame_;
    Pose now_;
    Array<Index> placed_;          // per placement: index into now_.placed
    Array<dmat4> view_to_object_;  // per index
    Beside before_, after_;
};

}  // namespace fovea::draw
