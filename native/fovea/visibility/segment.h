// SPDX-License-Identifier: GPL-3.0-or-later
// One segment of a projected path, as rays test it.
#pragma once

#include <fovea/base/view.h>
#include <fovea/path/paths.h>
#include <fovea/project/clipped_paths.h>
#include <fovea/scene/shadow_volume.h>

namespace fovea::visibility {

/// A segment of a piece, with its ends in view space, where rays test it (offset by Ignore::above). Positions along it
/// are screen fractions s in [0,1], or fractions t of its length in space.
struct Segment {
    dvec3 a, b;
    double wa, wb;  ///< distances along -z; equal (1) for an orthographic camera
    Ignore ignore;

    double to_space(double s) const { return share_in_space(s, wa, wb); }
    double to_screen(double t) const { return share_in_space(t, wb, wa); }
    dvec3 at(double s) const { return glm::mix(a, b, to_space(s)); }
};

/// The segment of `piece` that starts at point i of the clipped paths; `paths` are those that were clipped. Throws
/// std::invalid_argument where they are not of the tracer's scene.
Segment segment_at(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, Index piece, Index i);

/// The part of a segment that is certain to be hidden, in screen fractions.
Interval hidden_by(const Occluding& by, const Tracer& tracer, const Segment& segment);

/// Throws std::invalid_argument where `clipped` cannot come from `paths`; `what` names the caller.
void check_same_paths(const ClippedPaths& clipped, const Paths& paths, const char* what);

}  // namespace fovea::visibility
