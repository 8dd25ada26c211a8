// SPDX-License-Identifier: GPL-3.0-or-later
// The priority buffer: an image of line ranks, each line drawn as wide as its required distance from others.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/elision/bands.h>

namespace fovea::elision {

/// A band's entry at a pixel.
struct PriorityTexel {
    std::uint32_t rank : 23;     ///< of the line (elision/priority.h); 0: none
    std::uint32_t crossed : 1;   ///< 1 if the second layer holds another band
    std::uint32_t coverage : 8;  ///< coverage of the pixel by the band, times 255
    /// Vector across the line, from its center towards the pixel's center, in units of 1 / away_unit. Its length is 1,
    /// falling to .5 towards the ends of the band (Bands::across).
    std::int32_t away_x : 15, away_y : 15;
    std::uint32_t right : 1;  ///< 1 if the band's nearer end lies to the right of `away`

    static constexpr float away_unit = 16383.0f;
};

/// Two layers, so that a crossing line does not mask one that runs alongside: `first` is the band of highest rank at a
/// pixel, `second` the highest of those at more than 45 degrees to it; undefined where `first` is not crossed. Bottom
/// row first, width x height. Cole 2009, section 5.2.2, has one layer.
struct PriorityBuffer {
    int width = 0, height = 0;
    Array<PriorityTexel> first, second;
};

/// Rasterizes bands by pixel centers, clipped to the picture. Of bands of one rank at a pixel, the first drawn stays.
/// Parallel over tiles; independent of the number of threads. May throw Cancelled.
PriorityBuffer draw_priorities(const Bands& bands, int width, int height, const Cancel* cancel = nullptr);

}  // namespace fovea::elision
