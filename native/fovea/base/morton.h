// SPDX-License-Identifier: GPL-3.0-or-later
// Morton (Z-order) codes.
#pragma once

#include <fovea/base/types.h>

namespace fovea::base {

/// Interleaves the lower 20 bits of the three coordinates into a Morton code, so that points with close codes are
/// mostly close in space. Morton, "A Computer Oriented Geodetic Data Base", 1966.
inline std::uint64_t along_curve(const glm::uvec3& p) {
    const auto spread = [](std::uint64_t x) {
        x = (x | x << 32) & 0x1f00000000ffffull;
        x = (x | x << 16) & 0x1f0000ff0000ffull;
        x = (x | x << 8) & 0x100f00f00f00f00full;
        x = (x | x << 4) & 0x10c30c30c30c30c3ull;
        return (x | x << 2) & 0x1249249249249249ull;
    };
    return spread(p.x) | spread(p.y) << 1 | spread(p.z) << 2;
}

}  // namespace fovea::base
