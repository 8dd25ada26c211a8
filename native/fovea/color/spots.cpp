// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/spots.h>

#include <algorithm>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/parallel.h>

namespace fovea::color {

Array<Spot> small_spots(const Array<std::uint8_t>& black, int width, double least) {
    const int height = int(black.size() / std::size_t(width));
    const auto at = [&](int x, int y) { return std::size_t(y) * width + x; };
    DisjointSets same(black.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = at(x, y);
            if (x > 0 && black[i] == black[i - 1]) same.join(Index(i), Index(i - 1));
            if (y > 0 && black[i] == black[i - width]) same.join(Index(i), Index(i - width));
        }
    Array<float> size(black.size(), 0.0f);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool at_border = x == 0 || y == 0 || x == width - 1 || y == height - 1;
            size[same.name(Index(at(x, y)))] += at_border ? float(least) : 1.0f;
        }
    Array<std::uint8_t> small(black.size());
    for (std::size_t i = 0; i < black.size(); ++i) small[i] = size[same.name(Index(i))] < float(least);
    Array<Spot> spots(black.size(), Spot::as_is);
    parallel_for(height, 16, [&](std::size_t row) {
        const int y = int(row);
        for (int x = 0; x < width; ++x) {
            const std::size_t i = at(x, y);
            const auto answer = [&](bool is_black) { return is_black ? Spot::open : Spot::filled; };
            if (small[i]) spots[i] = answer(black[i]);
            if (small[i]) continue;
            // Of the other kind beside it: a small spot, and what stays.
            bool beside = false, stays = false;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
                    if (black[at(u, v)] != black[i]) (small[at(u, v)] ? beside : stays) = true;
            if (!stays && (beside || !black[i])) spots[i] = answer(!black[i]);
        }
    });
    return spots;
}

}  // namespace fovea::color
