// SPDX-License-Identifier: GPL-3.0-or-later
// Hidden parts that lie beside visible lines.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea {

/// Runs without the hidden parts that go along a visible run, or on under it, at less than `near_px`: where lines
/// coincide, the visible one is drawn (as ISO 128 has it), and no outline of a coarse mesh is accompanied by its own
/// way back. Hidden lines that cross visible ones stay whole. Parallel; the same for any number of threads.
Runs without_beside_visible(const ClippedPaths& clipped, const Runs& runs, double near_px);

}  // namespace fovea
