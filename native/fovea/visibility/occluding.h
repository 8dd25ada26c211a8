// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle that a ray met, and what it hides of segments.
#pragma once

#include <fovea/visibility/segment.h>
#include <fovea/visibility/shadow.h>

namespace fovea {

/// The shadow of a hit's outline (Tracer::outline), and of which surface it is.
class Occluding {
   public:
    Occluding() = default;
    Occluding(const Tracer& tracer, const Hit& hit);

    /// The part of a segment that it surely hides, in screen fractions; empty where the segment ignores it.
    Interval hides(const Tracer& tracer, const Segment& segment) const;

   private:
    Shadow shadow_;
    Index placement_ = none, triangle_ = none, other_ = none;
};

}  // namespace fovea
