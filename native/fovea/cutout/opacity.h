// SPDX-License-Identifier: GPL-3.0-or-later
// Opacity images of materials, such as those of cards with leaves, hair or fences.
#pragma once

#include <fovea/base/types.h>

namespace fovea::cutout {

/// What an image is where texture coordinates leave [0, 1].
enum class Extension {
    repeat,
    extend,  ///< as at its border
    clip,    ///< transparent
    mirror,  ///< repeated, every other time mirrored
};

/// Opacity of a material over its texture coordinates.
struct Opacity {
    Array<float> texels;  ///< rows from bottom to top
    int width = 0, height = 0;
    float threshold = 0.5f;  ///< opaque above it
    Extension extension = Extension::repeat;
    bool closest = false;  ///< texels are squares, else opacity is interpolated between their centers

    float at(int x, int y) const;
};

/// The image at half the size, each texel the mean of what it covers, with the threshold that leaves the same share of
/// it opaque: otherwise leaves would thin out with distance. Castano, "Computing Alpha Mipmaps", 2010.
Opacity halved(const Opacity& opacity);

}  // namespace fovea::cutout
