// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/scan.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/study/parts.h>

namespace fovea::study {
namespace {

constexpr double window = 31.0, least_speck = 6.0;
constexpr double share_of_paper = 1.0 / 3;  // darker than that is ink, however wide

/// Sums over the rectangle from (0, 0) to each corner of a pixel: (width + 1) x (height + 1).
Array<std::int64_t> summed(const color::GrayImage& picture) {
    const auto width = std::size_t(picture.width), stride = width + 1;
    Array<std::int64_t> sums(stride * (std::size_t(picture.height) + 1), 0);
    for (std::size_t y = 0; y < std::size_t(picture.height); ++y) {
        std::int64_t row = 0;
        for (std::size_t x = 0; x < width; ++x) {
            row += picture.values[y * width + x];
            sums[(y + 1) * stride + x + 1] = sums[y * stride + x + 1] + row;
        }
    }
    return sums;
}

}  // namespace

int paper_of(const color::GrayImage& picture) {
    std::array<std::size_t, 256> counts{};
    for (const std::uint8_t value : picture.values) ++counts[value];
    std::size_t below = 0;
    int value = 0;
    while (2 * (below += counts[std::size_t(value)]) < picture.values.size()) ++value;
    return value;
}

Bitmap ink_of(const color::GrayImage& given) {
    check(given.width > 0 && given.height > 0, "a drawing needs pixels");
    color::GrayImage picture = given;
    int paper = paper_of(picture);
    if (paper < dark_paper) {
        for (std::uint8_t& value : picture.values) value = std::uint8_t(255 - value);
        paper = 255 - paper;
    }
    const double scale = std::max(1.0, scale_of(picture.width, picture.height));
    const int half = int(std::lround(0.5 * (window - 1.0) * scale));
    const Array<std::int64_t> sums = summed(picture);
    const std::size_t stride = std::size_t(picture.width) + 1;
    Bitmap ink(picture.width, picture.height);
    parallel_for(std::size_t(picture.height), 16, [&](std::size_t row) {
        const int y = int(row), low = std::max(0, y - half), high = std::min(picture.height, y + half + 1);
        for (int x = 0; x < picture.width; ++x) {
            const int left = std::max(0, x - half), right = std::min(picture.width, x + half + 1);
            const auto at = [&](int i, int j) { return sums[std::size_t(j) * stride + std::size_t(i)]; };
            const std::int64_t sum = at(right, high) - at(left, high) - at(right, low) + at(left, low);
            const std::int64_t count = std::int64_t(right - left) * (high - low);
            const std::size_t i = row * std::size_t(picture.width) + std::size_t(x);
            const std::int64_t value = picture.values[i];
            ink.set[i] = (value + std::int64_t(least_ink)) * count < sum || double(value) < share_of_paper * paper;
        }
    });
    return without_specks(ink, std::size_t(std::lround(least_speck * scale)));
}

}  // namespace fovea::study
