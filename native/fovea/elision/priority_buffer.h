// SPDX-License-Identifier: GPL-3.0-or-later
// The priority buffer: an image of lines by rank, each as wide as the distance it wants to keep from others.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/elision/bands.h>

namespace fovea::elision {

/// What a band holds of a pixel.
struct PriorityTexel {
    std::uint32_t rank : 23;     ///< of the line (elision/priority.h); 0: none
    std::uint32_t crossed : 1;   ///< 1 where there is another band in the layer behind
    std::uint32_t coverage : 8;  ///< share of the pixel that the band covers, of 255
    /// Vector across the line, away from its middle towards the pixel's center, of `away_unit`; its length is 1, and
    /// towards the ends of the band falls to .5 (Bands::across).
    std::int32_t away_x : 15, away_y : 15;
    std::uint32_t right : 1;  ///< 1 where the nearer end of the band lies to the right of `away`

    static constexpr float away_unit = 16383.0f;
};

/// Two layers, so that a line that merely crosses does not hide one that goes along: `first` is the band of highest
/// rank at a pixel, `second` the highest of those that go at more than 45 degrees to it, and undefined where `first` is
/// not crossed. Bottom row first, width x height. Cole 2009, section 5.2.2, has one layer.
struct PriorityBuffer {
    int width = 0, height = 0;
    Array<PriorityTexel> first, second;
};

/// Draws bands by the pixel's center; what lies outside of the picture is left out. Where bands of one rank share a
/// pixel, the first drawn has it. Parallel over tiles; the same for any number of threads. May throw Cancelled.
PriorityBuffer draw_priorities(const Bands& bands, int width, int height, const Cancel* cancel = nullptr);

}  // namespace fovea::elision
