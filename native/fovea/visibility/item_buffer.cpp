// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/item_buffer.h>

#include <cmath>

#include <fovea/base/check.h>

namespace fovea::visibility {
namespace formulas {

using namespace glm;

struct Items {
#include <shared/item.glsl>
};

}  // namespace formulas

namespace {

constexpr int most_layers = 3;
constexpr int band_rows = 32;

/// A segment in texels, rasterized along its major axis.
struct Line {
    dvec2 from, to;
    double depth_from, depth_to;
    Index item;
    bool along_x;
};

/// Position in texels; bit-identical in all tiles that are offset by whole pixels.
dvec2 texels(const DepthBuffer& depth, vec2 px) {
    return (dvec2(px) + dvec2(depth.border_x, depth.border_y)) * double(depth.scale);
}

/// Whether x is the major axis.
bool along_x(dvec2 from, dvec2 to) { return std::abs(to.x - from.x) >= std::abs(to.y - from.y); }

/// First and last texel (excluded) with centers between a and b; the texel at the end is left to the next segment.
std::pair<int, int> texels_between(double a, double b, int size) {
    const double low = a <= b ? std::ceil(a - 0.5) : std::floor(b - 0.5) + 1.0;
    const double high = a <= b ? std::ceil(b - 0.5) : std::floor(a - 0.5) + 1.0;
    return {int(std::clamp(low, 0.0, double(size))), int(std::clamp(high, 0.0, double(size)))};
}

std::vector<Line> lines_of(const ClippedPaths& clipped, const DepthBuffer& depth) {
    std::vector<Line> lines;
    for (Index q = 0; q < clipped.pieces.count(); ++q)
        for (Index i = clipped.pieces.begin(q); i + 1 < clipped.pieces.end(q); ++i) {
            const dvec2 from = texels(depth, clipped.px[i]), to = texels(depth, clipped.px[i + 1]);
            if (clipped.sample_count[i] > 0)
                lines.push_back({from, to, clipped.depth[i], clipped.depth[i + 1], q + 1, along_x(from, to)});
        }
    return lines;
}

/// Rows of texels that a line may touch, last one excluded.
std::pair<int, int> rows_of(const Line& s, int height) {
    const auto [low, high] = std::minmax(s.from.y, s.to.y);
    return {int(std::clamp(std::floor(low) - 1.0, 0.0, double(height))),
            int(std::clamp(std::floor(high) + 2.0, 0.0, double(height)))};
}

class Drawing {
   public:
    Drawing(const DepthBuffer& depth, const ItemOptions& options, ItemBuffer& buffer)
        : depth_(depth), options_(options), buffer_(buffer), nearness_(buffer.items.size()) {}

    void draw(const Line& s, int row_begin, int row_end) {
        if (s.along_x)
            draw_along_x(s, row_begin, row_end);
        else
            draw_along_y(s, row_begin, row_end);
    }

   private:
    void draw_along_x(const Line& s, int row_begin, int row_end) {
        auto [begin, end] = texels_between(s.from.x, s.to.x, buffer_.width);
        const double step = (s.to.y - s.from.y) / (s.to.x - s.from.x);
        if (step != 0.0) {  // only the part in these rows, a texel wider for rounding
            const double a = s.from.x + (row_begin - s.from.y) / step, b = s.from.x + (row_end - s.from.y) / step;
            begin = int(std::max<double>(begin, std::floor(std::min(a, b)) - 2.0));
            end = int(std::min<double>(end, std::ceil(std::max(a, b)) + 2.0));
        }
        for (int x = begin; x < end; ++x) {
            const double t = (x + 0.5 - s.from.x) / (s.to.x - s.from.x);
            const int y = int(std::floor(glm::mix(s.from.y, s.to.y, t)));
            if (y >= row_begin && y < row_end) put(x, y, s, t);
        }
    }

    void draw_along_y(const Line& s, int row_begin, int row_end) {
        const auto [begin, end] = texels_between(s.from.y, s.to.y, buffer_.height);
        for (int y = std::max(begin, row_begin); y < std::min(end, row_end); ++y) {
            const double t = (y + 0.5 - s.from.y) / (s.to.y - s.from.y), x = std::floor(glm::mix(s.from.x, s.to.x, t));
            if (x >= 0.0 && x < buffer_.width) put(int(x), y, s, t);
        }
    }

    void put(int x, int y, const Line& s, double t) {
        const float depth = float(glm::mix(s.depth_from, s.depth_to, t));
        const DepthTexel& here = depth_.at(x, y);
        const vec3 plane(here.depth, here.ddx, here.ddy);
        if (here.facet != none &&
            formulas::Items{}.item_hidden(plane, depth, float(depth_.scale), options_.slope_factor, options_.bias))
            return;
        const std::size_t first = (std::size_t(y) * buffer_.width + x) * buffer_.layers;
        insert(&buffer_.items[first], &nearness_[first], s.item, std::min(depth, 1.0f));
    }

    /// Inserts into a list of unique items, nearest first.
    void insert(Index* items, float* nearness, Index item, float depth) {
        int last = 0;  // entry to replace: the item's own, else the first free one, else the farthest
        while (last < buffer_.layers - 1 && items[last] != 0 && items[last] != item) ++last;
        if (items[last] != 0 && depth < nearness[last]) return;
        for (; last > 0 && depth >= nearness[last - 1]; --last) {
            items[last] = items[last - 1];
            nearness[last] = nearness[last - 1];
        }
        items[last] = item;
        nearness[last] = depth;
    }

    const DepthBuffer& depth_;
    const ItemOptions& options_;
    ItemBuffer& buffer_;
    Array<float> nearness_;  // depth of each item
};

/// Lines by the bands of rows that they touch, in order.
Lists<Index> bin(const std::vector<Line>& lines, int height) {
    return lists_of<Index>((height + band_rows - 1) / band_rows, [&](const auto& give) {
        for (Index i = 0; i < lines.size(); ++i) {
            const auto [begin, end] = rows_of(lines[i], height);
            for (int b = begin / band_rows; b * band_rows < end; ++b) give(b, i);
        }
    });
}

/// Share of the probes of sample j of segment i that find the piece.
float share_seen(const ClippedPaths& clipped, const DepthBuffer& depth, const ItemBuffer& buffer, Index piece, Index i,
                 Index j) {
    const float middle = (float(j) + 0.5f) / float(clipped.sample_count[i]);
    if (!depth.decides(glm::mix(clipped.px[i], clipped.px[i + 1], middle))) return 0.0f;
    const dvec2 from = texels(depth, clipped.px[i]), to = texels(depth, clipped.px[i + 1]);
    const bool x_wise = along_x(from, to);
    int seen = 0;
    for (int k = 0; k < depth.scale; ++k) {
        const double t = (j + (k + 0.5) / depth.scale) / clipped.sample_count[i];
        const glm::ivec2 at(glm::floor(glm::mix(from, to, t)));
        bool found = false;
        for (int side = -1; side <= 1 && !found; ++side)
            found = buffer.holds(at.x + (x_wise ? 0 : side), at.y + (x_wise ? side : 0), piece + 1);
        seen += found;
    }
    return float(seen) / float(depth.scale);
}

}  // namespace

bool ItemBuffer::holds(int x, int y, Index item) const {
    if (x < 0 || y < 0 || x >= width || y >= height) return false;
    const Index* first = &items[(std::size_t(y) * width + x) * layers];
    return std::find(first, first + layers, item) != first + layers;
}

ItemBuffer draw_items(const ClippedPaths& clipped, const DepthBuffer& depth, const ItemOptions& options,
                      const Cancel* cancel) {
    check(options.layers >= 1 && options.layers <= most_layers, "item buffer: 1 to 3 layers expected");
    check(depth.width > 0 && depth.height > 0, "item buffer: the depth buffer is empty");
    ItemBuffer buffer{depth.width, depth.height, options.layers, {}};
    buffer.items.assign(std::size_t(depth.width) * depth.height * options.layers, 0);
    const std::vector<Line> lines = lines_of(clipped, depth);
    const Lists<Index> bands = bin(lines, depth.height);
    Drawing drawing(depth, options, buffer);
    parallel_for(bands.count(), 1, [&](std::size_t band) {
        if (cancel) cancel->poll();
        const int begin = int(band) * band_rows, end = std::min(begin + band_rows, depth.height);
        for (const Index line : bands[Index(band)]) drawing.draw(lines[line], begin, end);
    });
    return buffer;
}

Array<float> item_visibility(const ClippedPaths& clipped, const DepthBuffer& depth, const ItemOptions& options,
                             const Cancel* cancel) {
    const ItemBuffer buffer = draw_items(clipped, depth, options, cancel);
    Array<float> visibility(clipped.samples, 0.0f);
    parallel_blocks(clipped.pieces.count(), 64, [&](auto, std::size_t begin, std::size_t end) {
        if (cancel) cancel->poll();
        for (Index q = Index(begin); q < end; ++q)
            for (Index i = clipped.pieces.begin(q); i + 1 < clipped.pieces.end(q); ++i)
                for (Index j = 0; j < clipped.sample_count[i]; ++j)
                    visibility[clipped.sample_start[i] + j] = share_seen(clipped, depth, buffer, q, i, j);
    });
    return visibility;
}

}  // namespace fovea::visibility
