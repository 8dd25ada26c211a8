// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/depth_tiles.h>

#include <fovea/base/check.h>

namespace fovea {
namespace {

/// A tile along one axis [px of the whole, its border included].
struct Span {
    int begin, end;  // shown
    int core_begin, core_end;
};

std::vector<Span> spans(int size, int most, int overlap) {
    if (size <= most) return {{0, size, 0, size}};
    const int inner = most - 2 * overlap;
    check(inner > 0, "depth tiles: too few texels for a tile with its overlap");
    const int count = (size + inner - 1) / inner;
    std::vector<Span> result;
    for (int i = 0; i < count; ++i) {
        const int begin = int(std::int64_t(size) * i / count), end = int(std::int64_t(size) * (i + 1) / count);
        result.push_back({std::max(begin - overlap, 0), std::min(end + overlap, size), begin, end});
    }
    return result;
}

}  // namespace

std::vector<DepthBuffer> depth_tiles(const View& view, const DepthOptions& options, int side, int overlap_px) {
    const DepthBuffer whole = depth_layout(view, options);
    const int width = whole.width / whole.scale, height = whole.height / whole.scale;
    std::vector<DepthBuffer> tiles;
    for (const Span& y : spans(height, side / whole.scale, overlap_px))
        for (const Span& x : spans(width, side / whole.scale, overlap_px)) {
            DepthBuffer tile = whole;
            tile.border_x = whole.border_x - x.begin;
            tile.border_y = whole.border_y - y.begin;
            tile.width = (x.end - x.begin) * whole.scale;
            tile.height = (y.end - y.begin) * whole.scale;
            // What lies beyond the border belongs to the outermost tiles.
            if (x.core_begin > 0) tile.core.x = float(x.core_begin - whole.border_x);
            if (y.core_begin > 0) tile.core.y = float(y.core_begin - whole.border_y);
            if (x.core_end < width) tile.core.z = float(x.core_end - whole.border_x);
            if (y.core_end < height) tile.core.w = float(y.core_end - whole.border_y);
            tiles.push_back(std::move(tile));
        }
    return tiles;
}

}  // namespace fovea
