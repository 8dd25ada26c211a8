// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen beside a line: tells whether sampled visibility errs near a change of visibility or far from one.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/paths.h>
#include <fovea/project/clipped_paths.h>
#include <fovea/scene/tracer.h>

namespace fovea {

/// Per atlas sample: 1 where its point, moved `offset_px` pixels to the left of its segment (as seen, at the same
/// distance along the view), is exactly visible, under the rules of exact.h. Lines of the image are
/// seen everywhere. A segment without length in the image is moved up.
Array<std::uint8_t> seen_beside(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, double offset_px,
                                const Cancel& cancel);

}  // namespace fovea
