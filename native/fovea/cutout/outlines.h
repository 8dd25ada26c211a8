// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of the opaque region of an image, as closed polygons in its texture space.
#pragma once

#include <algorithm>

#include <fovea/cutout/opacity.h>

namespace fovea::cutout {

/// A point of texture space, in integers, so that every comparison of places is exact: 2^subtexel_bits units are a
/// texel. Points of outlines are odd, texture coordinates of meshes even: none of them coincide.
using Point = glm::vec<2, std::int64_t>;

/// Twice the signed area of a triangle. Exact for coordinates below 2^30.
inline std::int64_t turn(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

struct Box {
    Point low{INT64_MAX}, high{INT64_MIN};
    void add(const Point& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    bool meets(const Box& other) const {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
    }
};

/// The boundary of the opaque region within a box of texture space, and beyond it by a texel or two. Loops have what is
/// opaque on their left. They follow the bilinear interpolation of the texels (or the sides of square texels) within a
/// quarter of a texel; islands and holes of a single texel are left out, unless texels are square.
class Outlines {
   public:
    /// `low`, `high`: the box, in texture coordinates. At most most_nodes texels.
    Outlines(const Opacity& opacity, const vec2& low, const vec2& high);

    /// Texels that the box may cover.
    static constexpr double most_nodes = 1 << 24;
    /// How many texels that is.
    static double nodes(const Opacity& opacity, const vec2& low, const vec2& high);

    /// The even point nearest to texture coordinates.
    Point point(const vec2& uv) const;
    double texel() const { return double(std::int64_t(1) << bits_); }  ///< its side

    const Array<Point>& points() const { return loops_.values; }
    Index next(Index point) const { return next_[point]; }
    Index loop_count() const { return loops_.count(); }
    In<Point> loop(Index number) const { return loops_[number]; }
    Index first(Index number) const { return loops_.begin(number); }
    const Box& box(Index number) const { return boxes_[number]; }

    /// Calls found(point) for each segment, by the point where it starts, whose box meets a box; ascending.
    template <typename Found>
    void each_segment(const Box& box, std::vector<Index>& scratch, const Found& found) const {
        scratch.clear();
        const Index end = row_of(box.high.y);
        for (Index row = row_of(box.low.y); row <= end && rows_.count() > 0; ++row)
            for (const Index i : rows_[row]) {
                const Point &a = points()[i], &b = points()[next_[i]];
                if (std::max(a.x, b.x) >= box.low.x && std::min(a.x, b.x) <= box.high.x &&
                    std::max(a.y, b.y) >= box.low.y && std::min(a.y, b.y) <= box.high.y)
                    scratch.push_back(i);
            }
        std::sort(scratch.begin(), scratch.end());
        scratch.erase(std::unique(scratch.begin(), scratch.end()), scratch.end());
        for (const Index i : scratch) found(i);
    }

    /// Whether an even point lies in the opaque region.
    bool opaque(const Point& at) const;

   private:
    Index row_of(std::int64_t y) const;
    void sort_into_rows();

    int bits_;
    int width_, height_;
    Lists<Point> loops_;
    Array<Index> next_;
    std::vector<Box> boxes_;
    Lists<Index> rows_;  // segments by the rows of texture space that they reach into
    std::int64_t rows_low_ = 0, row_side_ = 1;
};

}  // namespace fovea::cutout
