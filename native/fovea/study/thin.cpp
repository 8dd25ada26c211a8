// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/thin.h>

#include <algorithm>
#include <array>

#include <fovea/base/cancel.h>

namespace fovea::study {
namespace {

/// Steps to the neighbors of a pixel in rows of `stride`, counterclockwise from the one above.
std::array<std::ptrdiff_t, 8> neighbors_in(std::ptrdiff_t stride) {
    return {stride, stride - 1, -1, -stride - 1, -stride, -stride + 1, 1, stride + 1};
}

/// Bit `around` (a bit per neighbor, in the order above): whether a pixel with these neighbors is taken away in the
/// first or second half of a pass.
std::array<std::array<bool, 256>, 2> tables() {
    std::array<std::array<bool, 256>, 2> table{};
    for (unsigned around = 0; around < 256; ++around) {
        const auto p = [&](int i) { return (around >> (i & 7) & 1) != 0; };
        int parts = 0, pairs = 0, other_pairs = 0;
        for (int i = 0; i < 8; i += 2) {
            parts += !p(i) && (p(i + 1) || p(i + 2));
            pairs += p(i) || p(i + 1);
            other_pairs += p(i + 1) || p(i + 2);
        }
        const int count = std::min(pairs, other_pairs);
        const bool is_border = parts == 1 && (count == 2 || count == 3);
        table[0][around] = is_border && !((p(0) || p(1) || !p(3)) && p(2));
        table[1][around] = is_border && !((p(4) || p(5) || !p(7)) && p(6));
    }
    return table;
}

/// The bitmap in a frame of empty pixels, so that each has all neighbors.
struct Framed {
    std::ptrdiff_t stride;
    Array<std::uint8_t> set;
    std::vector<std::ptrdiff_t> pixels;  ///< those that are set

    explicit Framed(const Bitmap& bitmap)
        : stride(bitmap.width + 2), set(std::size_t(stride) * std::size_t(bitmap.height + 2), 0) {
        for (int y = 0; y < bitmap.height; ++y)
            for (int x = 0; x < bitmap.width; ++x)
                if (bitmap.set[std::size_t(y) * std::size_t(bitmap.width) + std::size_t(x)])
                    pixels.push_back((y + 1) * stride + x + 1);
        for (const std::ptrdiff_t i : pixels) (*this)[i] = 1;
    }
    std::uint8_t& operator[](std::ptrdiff_t i) { return set[std::size_t(i)]; }

    void write(Bitmap& bitmap) {
        for (int y = 0; y < bitmap.height; ++y)
            std::copy_n(&(*this)[(y + 1) * stride + 1], bitmap.width,
                        bitmap.set.begin() + std::ptrdiff_t(y) * bitmap.width);
    }
};

}  // namespace

Bitmap thinned(Bitmap bitmap) {
    static const auto table = tables();
    Framed framed(bitmap);
    const auto neighbors = neighbors_in(framed.stride);
    std::vector<std::ptrdiff_t> taken;
    for (int half = 0, unchanged = 0; unchanged < 2; half = 1 - half) {
        Cancelling::poll();
        taken.clear();
        for (const std::ptrdiff_t i : framed.pixels) {
            unsigned around = 0;
            for (unsigned k = 0; k < 8; ++k) around |= unsigned(framed[i + neighbors[k]]) << k;
            if (table[std::size_t(half)][around]) taken.push_back(i);
        }
        for (const std::ptrdiff_t i : taken) framed[i] = 0;
        std::erase_if(framed.pixels, [&](std::ptrdiff_t i) { return !framed[i]; });
        unchanged = taken.empty() ? unchanged + 1 : 0;
    }
    framed.write(bitmap);
    return bitmap;
}

}  // namespace fovea::study
