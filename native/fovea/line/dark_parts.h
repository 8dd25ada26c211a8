// SPDX-License-Identifier: GPL-3.0-or-later
// What is known to be dark of segments that a light is asked about one after the other: of each surface that was found
// to hide a point of one, all that it hides of that and of the next ones is known, and needs no rays.
#pragma once

#include <fovea/line/light_eye.h>
#include <fovea/scene/shadow_volume.h>

namespace fovea::line {

class DarkParts {
   public:
    /// The eye must outlive it.
    explicit DarkParts(const LightEye& eye) : eye_(eye) {}

    /// Ends of the segment that is asked about from here on, in the space of the eye, and what rays ignore at it.
    void next_segment(const dvec3& from, const dvec3& to, const Ignore& ignore);

    /// A part around its point at parameter t that is certain to be dark; empty if none is known.
    Interval known(double t);
    /// The same, knowing that this hides the point: at least the point itself.
    Interval hidden_by(const Hit& hit, double t);

   private:
    Interval of(const Occluding& by) const { return by.hides(eye_.tracer, from_, to_, ignore_); }

    const LightEye& eye_;
    dvec3 from_{0.0}, to_{0.0};
    Ignore ignore_;
    scene::Remembered<Occluding, 4> hiding_;
};

}  // namespace fovea::line
