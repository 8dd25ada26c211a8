// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/nearest_pixel.h>

#include <cmath>
#include <limits>

#include <fovea/base/parallel.h>

namespace fovea::study {
namespace {

constexpr std::size_t lines_at_once = 16;

/// Row of the nearest set pixel in the same column; -1: the column is empty.
Array<int> rows_in_columns(const Bitmap& bitmap) {
    const auto width = std::size_t(bitmap.width);
    Array<int> row(bitmap.set.size());
    parallel_for(width, lines_at_once, [&](std::size_t x) {
        int below = -1;
        for (int y = 0; y < bitmap.height; ++y) {
            const std::size_t i = std::size_t(y) * width + x;
            if (bitmap.set[i]) below = y;
            row[i] = below;
        }
        int above = -1;
        for (int y = bitmap.height; y-- > 0;) {
            const std::size_t i = std::size_t(y) * width + x;
            if (bitmap.set[i]) above = y;
            if (above >= 0 && (row[i] < 0 || above - y < y - row[i])) row[i] = above;
        }
    });
    return row;
}

/// The lower envelope of the parabolas (x - center)^2 + height along a row.
struct Envelope {
    struct Part {
        std::int64_t center, height;
        std::int64_t from;  ///< first x at which it is the lowest
    };
    std::vector<Part> parts;

    void add(std::int64_t center, std::int64_t height, std::int64_t width) {
        const auto value = [](const Part& p, std::int64_t x) { return (x - p.center) * (x - p.center) + p.height; };
        const Part added{center, height, 0};
        while (!parts.empty() && value(parts.back(), parts.back().from) > value(added, parts.back().from))
            parts.pop_back();
        if (parts.empty()) return parts.push_back(added);
        const Part& last = parts.back();
        const std::int64_t above = center * center - last.center * last.center + height - last.height;
        const std::int64_t span = 2 * (center - last.center);
        const std::int64_t meet = above / span - (above % span < 0) + 1;
        if (meet < width) parts.push_back({center, height, meet});
    }
};

}  // namespace

Array<Index> nearest_pixels(const Bitmap& bitmap) {
    const Array<int> rows = rows_in_columns(bitmap);
    const auto width = std::size_t(bitmap.width);
    Array<Index> nearest(rows.size(), none);
    parallel_for(std::size_t(bitmap.height), lines_at_once, [&](std::size_t y) {
        const int* const row = rows.data() + y * width;
        Envelope envelope;
        for (std::size_t x = 0; x < width; ++x) {
            const std::int64_t up = row[x] - std::int64_t(y);
            if (row[x] >= 0) envelope.add(std::int64_t(x), up * up, std::int64_t(width));
        }
        const auto& parts = envelope.parts;
        for (std::size_t p = 0; p < parts.size(); ++p) {
            const auto end = p + 1 < parts.size() ? std::size_t(parts[p + 1].from) : width;
            const auto center = std::size_t(parts[p].center);
            for (auto x = std::size_t(parts[p].from); x < end; ++x)
                nearest[y * width + x] = Index(std::size_t(row[center]) * width + center);
        }
    });
    return nearest;
}

Array<float> distances_to(const Bitmap& bitmap) {
    const Array<Index> nearest = nearest_pixels(bitmap);
    return parallel_map<float>(nearest.size(), [&](std::size_t i) {
        if (nearest[i] == none) return std::numeric_limits<float>::infinity();
        return float(glm::distance(center_of(i, bitmap.width), center_of(nearest[i], bitmap.width)));
    });
}

}  // namespace fovea::study
