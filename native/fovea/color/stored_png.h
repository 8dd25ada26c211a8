// SPDX-License-Identifier: GPL-3.0-or-later
// The pixels of a PNG file as it stores them, for comparing pictures and for finding files that broke off.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <fovea/base/types.h>

namespace fovea::color {

struct StoredPng {
    int width = 0, height = 0;
    int channels = 0;                  ///< of a palette: 1, its entry
    int bits = 0;                      ///< of a value: 1, 2, 4, 8 or 16
    std::vector<std::uint8_t> values;  ///< rows from the top, each begins with a byte; 16 bits: the higher byte first
};

/// Reads all of a file's bytes. Throws std::invalid_argument if they break off, or if a sum over them is wrong.
StoredPng stored_png(In<std::uint8_t> file);

}  // namespace fovea::color
