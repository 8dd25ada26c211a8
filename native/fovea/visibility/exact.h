// SPDX-License-Identifier: GPL-3.0-or-later
// Exact visibility: rays along paths, and the shadows of the triangles they meet.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/paths.h>
#include <fovea/scene/tracer.h>
#include <fovea/visibility/runs.h>

namespace fovea::visibility {

/// Changes of visibility are found to this many pixels.
inline constexpr double exact_tolerance_px = 1.0 / 16.0;

/// Visible runs. One ray per atlas sample decides it, except where a triangle met before already hides it: a triangle
/// hides the part of a straight segment that lies in its shadow volume, one interval that is found in closed form, so
/// that all samples in it need no ray. Each change between samples is then narrowed to exact_tolerance_px.
Runs exact_visibility(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Cancel& cancel);

/// Per atlas sample: 1 where its point, moved `offset_px` pixels to the left of its segment (as seen, at the same
/// distance along the view), is exactly visible, under the same rules: tells whether sampled visibility errs near a
/// change of visibility or far from one. Lines of the image are seen everywhere. A segment without length in the image
/// is moved up.
Array<std::uint8_t> seen_beside(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, double offset_px,
                                const Cancel& cancel);

}  // namespace fovea::visibility
