// SPDX-License-Identifier: GPL-3.0-or-later
// Exact visibility: rays along paths, and shadow volumes of the triangles that they hit.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/paths.h>
#include <fovea/scene/tracer.h>
#include <fovea/visibility/runs.h>

namespace fovea::visibility {

/// Tolerance of the positions of visibility changes [px].
inline constexpr double exact_tolerance_px = 1.0 / 16.0;

/// Visible runs. One ray per atlas sample decides its visibility, unless a triangle hit before already hides it: the
/// part of a straight segment inside a triangle's shadow volume is one interval in closed form, and samples in it need
/// no ray. Each change between samples is then narrowed to exact_tolerance_px. Where only a ray tells that the first or
/// last sample of a segment is hidden, the segment's end is asked for: if it is hidden, too, so is all between.
Runs exact_visibility(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Cancel& cancel);

/// Per atlas sample: 1 where its point, offset by `offset_px` pixels to the left of its segment (in the image, at the
/// same distance along the view axis), is visible by the same exact rules. Tells whether errors of sampled visibility
/// lie near a change of visibility or far from one. Image-space lines are visible everywhere. The point of a segment
/// without length in the image is offset upwards.
Array<std::uint8_t> seen_beside(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, double offset_px,
                                const Cancel& cancel);

}  // namespace fovea::visibility
