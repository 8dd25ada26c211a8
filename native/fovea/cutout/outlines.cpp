// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/cutout/outlines.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include <fovea/base/parallel.h>

namespace fovea::cutout {
namespace {

constexpr int side_bits = 20, least_bits = 8;  // units of an image's side; of a texel
/// Deviation, in texels, up to which points of outlines are left out; and the area of the least island or hole.
constexpr double tolerance = 0.25, least_area = 0.75;
constexpr std::int64_t rows_at_most = 512;
constexpr float most_opaque = 1e6f;  // opacities are about 1; of endless ones there is no middle

std::int64_t odd(double v) { return 2 * static_cast<std::int64_t>(std::floor(0.5 * v)) + 1; }

/// The points, along one axis, between which opacity is interpolated: centers of texels, or both ends of square ones.
struct Axis {
    Array<int> texel;
    Array<double> place;
    Axis(int size, float low, float high, bool closest, double unit) {
        constexpr double inset = 1.0 / 128;  // of the ends of a square texel
        const int begin = static_cast<int>(std::floor(low * size - 0.5)) - 1;
        const int end = static_cast<int>(std::ceil(high * size - 0.5)) + 1;
        for (int i = begin; i <= end; ++i)
            for (const double at : closest ? std::vector{inset, 1.0 - inset} : std::vector{0.5}) {
                texel.push_back(i);
                place.push_back((i + at) * unit);
            }
    }
    int size() const { return static_cast<int>(texel.size()); }
};

/// Marching squares over the nodes of two axes. The outermost nodes are transparent, so that all loops close.
class Tracing {
   public:
    Tracing(const Opacity& opacity, const Axis& x, const Axis& y)
        : x_(x), y_(y), width_(x.size()), nodes_(std::size_t(width_) * y.size()), values_(nodes_) {
        parallel_for(y.size(), 16, [&](std::size_t j) {
            for (int i = 0; i < width_; ++i) {
                const bool rim = i == 0 || j == 0 || i + 1 == width_ || int(j) + 1 == y_.size();
                const float value = opacity.at(x_.texel[i], y_.texel[j]) - opacity.threshold;
                // Without an opacity above a threshold that is none, a node is transparent.
                const float below = value < -1e-6f ? std::max(value, -most_opaque) : -1e-6f;
                values_[j * width_ + i] = rim ? -1.0f : value > 0.0f ? std::min(value, most_opaque) : below;
            }
        });
    }

    std::vector<std::vector<Point>> loops() {
        Array<Index> next(2 * nodes_, none);
        parallel_for(y_.size() - 1, 16, [&](std::size_t j) {
            for (int i = 0; i + 1 < width_; ++i) link(i, int(j), next);
        });
        std::vector<std::vector<Point>> found;
        for (Index start = 0; start < next.size(); ++start) {
            if (next[start] == none) continue;
            auto& loop = found.emplace_back();
            for (Index at = start; next[at] != none; at = std::exchange(next[at], none)) loop.push_back(crossing(at));
        }
        return found;
    }

   private:
    bool opaque(std::size_t node) const { return values_[node] > 0.0f; }

    /// Links the crossings on the sides of a square: from where its outline, counterclockwise, leaves the opaque region
    /// to where it comes back.
    void link(int i, int j, Array<Index>& next) const {
        const std::size_t a = std::size_t(j) * width_ + i, d = a + width_;
        const std::size_t corners[4] = {a, a + 1, d + 1, d};
        const Index sides[4] = {Index(a), Index(nodes_ + a + 1), Index(d), Index(nodes_ + a)};
        int leaves[2], comes[2], count = 0, back = 0;
        for (int k = 0; k < 4; ++k) {
            const bool from = opaque(corners[k]), to = opaque(corners[(k + 1) % 4]);
            if (from && !to) leaves[count++] = k;
            if (!from && to) comes[back++] = k;
        }
        if (count == 1) next[sides[leaves[0]]] = sides[comes[0]];
        if (count < 2) return;
        // A saddle: its middle decides whether the opaque corners are one piece.
        const bool joined = values_[a] + values_[a + 1] + values_[d] + values_[d + 1] > 0.0f;
        for (const int leave : leaves) next[sides[leave]] = sides[(leave + (joined ? 1 : 3)) % 4];
    }

    Point crossing(Index id) const {
        const bool vertical = id >= nodes_;
        const std::size_t node = vertical ? id - nodes_ : id, other = node + (vertical ? width_ : 1);
        const double t = double(values_[node]) / (double(values_[node]) - double(values_[other]));
        const std::size_t i = node % width_, j = node / width_;
        const auto between = [&](const Axis& axis, std::size_t k) {
            return axis.place[k] + t * (axis.place[k + 1] - axis.place[k]);
        };
        return {odd(vertical ? x_.place[i] : between(x_, i)), odd(vertical ? between(y_, j) : y_.place[j])};
    }

    const Axis &x_, &y_;
    int width_;
    std::size_t nodes_;
    Array<float> values_;
};

double distance_to(const Point& p, const Point& a, const Point& b) {
    const dvec2 along(b - a), from(p - a);
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(from, along) / length2, 0.0, 1.0) : 0.0;
    return glm::length(from - t * along);
}

/// Douglas & Peucker, "Algorithms for the reduction of the number of points", 1973; the loop is halved first, at its
/// lowest point and the one farthest from it.
std::vector<Point> simplified(const std::vector<Point>& loop, double far) {
    const auto before = [](const Point& a, const Point& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); };
    std::vector<Point> ring(loop);
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), before), ring.end());
    ring.push_back(ring.front());
    std::vector<std::uint8_t> kept(ring.size(), 0);
    std::vector<std::pair<std::size_t, std::size_t>> spans;
    const auto away = [&](const Point& p) { return glm::length(dvec2(p - ring.front())); };
    const auto middle =
        std::max_element(ring.begin(), ring.end(), [&](const Point& a, const Point& b) { return away(a) < away(b); }) -
        ring.begin();
    kept[0] = kept[middle] = 1;
    spans.push_back({0, middle});
    spans.push_back({middle, ring.size() - 1});
    while (!spans.empty()) {
        const auto [begin, end] = spans.back();
        spans.pop_back();
        double worst = far;
        std::size_t at = end;
        for (std::size_t i = begin + 1; i < end; ++i)
            if (const double d = distance_to(ring[i], ring[begin], ring[end]); d > worst) {
                worst = d;
                at = i;
            }
        if (at == end) continue;
        kept[at] = 1;
        spans.push_back({begin, at});
        spans.push_back({at, end});
    }
    std::vector<Point> result;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
        if (kept[i] && (result.empty() || result.back() != ring[i])) result.push_back(ring[i]);
    return result;
}

double area(const std::vector<Point>& loop) {
    double sum = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        sum += 0.5 * double(turn(loop[0], loop[i], loop[(i + 1) % loop.size()]));
    return sum;
}

}  // namespace

double Outlines::nodes(const Opacity& opacity, const vec2& low, const vec2& high) {
    const dvec2 size = dvec2(high - low) * dvec2(opacity.width, opacity.height) + 4.0;
    return size.x * size.y * (opacity.closest ? 4.0 : 1.0);
}

Outlines::Outlines(const Opacity& opacity, const vec2& low, const vec2& high)
    : bits_(std::max(least_bits, side_bits - int(std::bit_width(unsigned(std::max(opacity.width, opacity.height)))))),
      width_(opacity.width),
      height_(opacity.height) {
    const Axis x(width_, low.x, high.x, opacity.closest, texel()), y(height_, low.y, high.y, opacity.closest, texel());
    std::vector<std::vector<Point>> found = Tracing(opacity, x, y).loops();
    parallel_for(found.size(), 16, [&](std::size_t i) {
        found[i] = simplified(found[i], tolerance * texel());
        if (found[i].size() < 3 || std::abs(area(found[i])) < least_area * texel() * texel()) found[i].clear();
    });
    for (const auto& loop : found) {
        if (loop.empty()) continue;
        Box& box = boxes_.emplace_back();
        const Index first = static_cast<Index>(loops_.values.size());
        for (const Point& p : loop) {
            box.add(p);
            loops_.values.push_back(p);
            next_.push_back(static_cast<Index>(loops_.values.size()));
        }
        next_.back() = first;
        loops_.offsets.push_back(static_cast<Index>(loops_.values.size()));
    }
    sort_into_rows();
}

void Outlines::sort_into_rows() {
    if (points().empty()) return;
    Box all;
    for (const Point& p : points()) all.add(p);
    rows_low_ = all.low.y;
    row_side_ = (all.high.y - all.low.y) / rows_at_most + 1;
    const Index count = static_cast<Index>((all.high.y - all.low.y) / row_side_ + 1);
    rows_.offsets.assign(count + 1, 0);  // row_of clamps to them
    rows_ = lists_of<Index>(count, [&](const auto& give) {
        for (Index i = 0; i < points().size(); ++i) {
            const auto [low, high] = std::minmax(points()[i].y, points()[next_[i]].y);
            for (Index row = row_of(low); row <= row_of(high); ++row) give(row, i);
        }
    });
}

Index Outlines::row_of(std::int64_t y) const {
    const std::int64_t last = std::int64_t(rows_.count()) - 1;
    return static_cast<Index>(
        std::clamp((y - rows_low_) / row_side_, std::int64_t(0), std::max(last, std::int64_t(0))));
}

Point Outlines::point(const vec2& uv) const {
    const dvec2 place = dvec2(uv) * dvec2(width_, height_) * texel();
    return {2 * std::llround(0.5 * place.x), 2 * std::llround(0.5 * place.y)};
}

bool Outlines::opaque(const Point& at) const {
    if (rows_.count() == 0) return false;
    int crossings = 0;
    for (const Index i : rows_[row_of(at.y)]) {
        const Point &a = points()[i], &b = points()[next_[i]];
        if ((a.y > at.y) == (b.y > at.y)) continue;
        crossings += (turn(a, b, at) > 0) == (b.y > a.y);  // it crosses to the right of the point
    }
    return crossings % 2 != 0;
}

}  // namespace fovea::cutout
