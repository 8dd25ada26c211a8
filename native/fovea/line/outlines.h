// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by contours and silhouettes, also smooth ones.
#pragma once

namespace fovea::line {

/// Importance of all outlines: what is behind one changes at once, and makes a silhouette of a contour, which must not
/// displace the lines beside it.
inline constexpr double outline_importance = 0.85;

}  // namespace fovea::line
