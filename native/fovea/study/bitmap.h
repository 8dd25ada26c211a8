// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings as sets of pixels.
#pragma once

#include <fovea/base/types.h>

namespace fovea::study {

using namespace vector;  // nothing that draws depends on this folder, so base/namespaces.h does not name it

/// Size of a picture, of which lengths are given in pixels, as a share of one of 1024 x 768: the ratio of diagonals.
inline double scale_of(int width, int height) { return glm::length(dvec2(width, height)) / 1280.0; }

/// A set of pixels, bottom row first; each value is 1 or 0.
struct Bitmap {
    int width = 0, height = 0;
    Array<std::uint8_t> set;

    Bitmap() = default;
    Bitmap(int w, int h) : width(w), height(h), set(std::size_t(w) * std::size_t(h), 0) {}

    std::size_t count() const;
    double diagonal() const;
    /// Throws std::invalid_argument if the other has another size.
    void check_size_of(const Bitmap& other) const;
};

/// Center of pixel number i.
inline dvec2 center_of(std::size_t i, int width) {
    return {double(i % std::size_t(width)) + 0.5, double(i / std::size_t(width)) + 0.5};
}

/// Lines as pixels, in steps of half a pixel; line i has the points rows.begin(i) .. rows.end(i), in pixels from the
/// lower left corner. What is outside is left out.
Bitmap pixels_of(In<vec2> px, In<std::int64_t> offsets, int width, int height);

/// The same with what the lines have at their points, in [0, 1]: the most at each pixel; -1 where there is no line.
Array<float> most_at_pixels(In<vec2> px, In<std::int64_t> offsets, In<float> values, int width, int height);

}  // namespace fovea::study
