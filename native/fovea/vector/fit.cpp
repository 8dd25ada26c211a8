// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/fit.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include <fovea/vector/fit_cubic.h>

namespace fovea::vector {
namespace {

constexpr double same = 1e-3;       // tolerances; points that near are one
constexpr double sharp = 0.87;      // cosine of the turn of a corner: 30 degrees
constexpr double look = 6.0;        // tolerances over which directions are measured
constexpr double most_rise = 14.0;  // tolerances; a smooth curve is a 14th of the side times the turn beside it
constexpr double for_points = 0.9;  // of the tolerance: the rest is for points that are left out
constexpr std::size_t lines_of_a_cubic = 3;  // that have as many numbers
constexpr std::size_t at_once = 200;         // points that one segment is tried for first
constexpr std::size_t beside = 3;            // points to each side of a joint that tell its tangent

Points distinct(In<dvec2> points, double near) {
    Points kept;
    dvec2 last(0.0);
    for (const dvec2& p : points) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
        if (kept.empty() || glm::distance(kept.back(), p) > near) kept.push_back(p);
        last = p;
    }
    // The end stays where it is.
    if (kept.size() > 1) kept.back() = last;
    return kept;
}

/// Points `i` of a polyline: those of a closed one, which has no last point here, go around.
class Corners {
   public:
    Corners(const Points& points, bool closed, double tolerance)
        : points_(points), closed_(closed), tolerance_(tolerance), count_(std::ptrdiff_t(points.size())) {}

    /// Indices of corners, ascending.
    std::vector<std::size_t> find() const {
        std::vector<double> turns(points_.size(), 1.0);
        std::vector<std::size_t> corners;
        const std::ptrdiff_t first = closed_ ? 0 : 1, last = closed_ ? count_ : count_ - 1;
        for (std::ptrdiff_t i = first; i < last; ++i) turns[i] = turn(i);
        for (std::ptrdiff_t i = first; i < last; ++i)
            if (is_corner(i, turns[i]) && is_sharpest(i, turns)) corners.push_back(std::size_t(i));
        return corners;
    }

   private:
    std::ptrdiff_t around(std::ptrdiff_t i) const { return closed_ ? (i + count_) % count_ : i; }
    bool is_there(std::ptrdiff_t i) const { return closed_ || (i >= 0 && i < count_); }
    double side(std::ptrdiff_t i, std::ptrdiff_t step) const {
        return glm::distance(points_[i], points_[around(i + step)]);
    }

    /// Direction from a point to those some way before (step -1) or after it (1).
    dvec2 direction(std::ptrdiff_t i, std::ptrdiff_t step) const {
        std::ptrdiff_t j = around(i + step);
        while (glm::distance(points_[i], points_[j]) < look * tolerance_ && is_there(j + step) && around(j + step) != i)
            j = around(j + step);
        const dvec2 way = points_[j] - points_[i];
        const double length = glm::length(way);
        return length > 0.0 ? way / length : dvec2(0.0);
    }

    /// Cosine of the turn at a point.
    double turn(std::ptrdiff_t i) const { return -glm::dot(direction(i, -1), direction(i, 1)); }

    bool is_corner(std::ptrdiff_t i, double turn) const {
        if (turn < sharp) return true;
        const double angle = std::sqrt(std::max(0.0, 2.0 - 2.0 * turn));  // its chord, next to the same
        return std::max(side(i, -1), side(i, 1)) * angle > most_rise * tolerance_;
    }

    /// Whether no turn nearby is sharper; of equal ones the first counts.
    bool is_sharpest(std::ptrdiff_t i, const std::vector<double>& turns) const {
        for (const std::ptrdiff_t step : {-1, 1}) {
            double way = side(i, step);
            for (std::ptrdiff_t j = around(i + step); way < look * tolerance_ && j != i; j = around(j + step)) {
                if (turns[j] < turns[i] || (turns[j] == turns[i] && step < 0)) return false;
                if (!is_there(j + step)) break;
                way += side(j, step);
            }
        }
        return true;
    }

    const Points& points_;
    bool closed_;
    double tolerance_;
    std::ptrdiff_t count_;
};

/// Whether points run along the line from the first to the last.
bool is_straight(In<dvec2> points, double tolerance) {
    const dvec2 first = points.front(), last = points.back();
    return std::ranges::all_of(points,
                               [&](const dvec2& p) { return distance_to_segment(p, first, last) <= tolerance; });
}

/// Unit tangent at a point, of the parabola through it that is nearest to its neighbors.
dvec2 tangent_at(In<dvec2> points, std::size_t i) {
    const std::size_t first = i > beside ? i - beside : 0, last = std::min(i + beside, points.size() - 1);
    double s2 = 0.0, s3 = 0.0, s4 = 0.0;
    dvec2 first_moment(0.0), second_moment(0.0);
    const auto add = [&](std::size_t j, double s) {
        const dvec2 d = points[j] - points[i];
        s2 += s * s;
        s3 += s * s * s;
        s4 += s * s * s * s;
        first_moment += s * d;
        second_moment += s * s * d;
    };
    double s = 0.0;
    for (std::size_t j = i; j-- > first;) add(j, s -= glm::distance(points[j], points[j + 1]));
    s = 0.0;
    for (std::size_t j = i; j++ < last;) add(j, s += glm::distance(points[j], points[j - 1]));
    const dvec2 slope = s4 * first_moment - s3 * second_moment;
    const double det = s2 * s4 - s3 * s3;
    const dvec2 way = det > 1e-9 * s2 * s4 ? slope / det : points[last] - points[first];
    const double length = glm::length(way);
    return length > 0.0 ? way / length : dvec2(1.0, 0.0);
}

/// Fits a part of a polyline without corners by as few numbers as it can. How far so many numbers reach is known from
/// how far fewer do: by a line two more reach on from there, by a cubic six more. That is the least if each part of
/// what one segment may stand for is such a part, too, which is nearly so.
class Smooth {
   public:
    Smooth(In<dvec2> points, double tolerance, const Tangents& ends, Curve& out)
        : points_(points), last_(points.size() - 1), tolerance_(tolerance), ends_(ends), out_(out) {}

    void add() {
        std::vector<Reach> by_lines{{}};  // how far 0, 1, 2 ... times two numbers reach
        while (by_lines.back().to < last_) {
            Reach reach = line_from(by_lines.back().to, by_lines.size() - 1);
            if (by_lines.size() >= lines_of_a_cubic) {
                const std::size_t before = by_lines.size() - lines_of_a_cubic;
                const Reach other = cubic_from(by_lines[before].to, before);
                // Of equals the smooth one.
                if (other.cubic && other.to >= reach.to) reach = other;
            }
            by_lines.push_back(reach);
        }
        std::vector<const Reach*> way;
        for (std::size_t i = by_lines.size() - 1; i > 0; i = by_lines[i].before) way.push_back(&by_lines[i]);
        for (const Reach* reach : std::views::reverse(way)) {
            const auto& cubic = reach->cubic;
            if (cubic)
                out_.cubic_to((*cubic)[1], (*cubic)[2], (*cubic)[3]);
            else
                out_.line_to(points_[reach->to]);
        }
    }

   private:
    /// A point that is reached, the number of the reach that its segment begins at, and that if it is a cubic.
    struct Reach {
        std::size_t to = 0, before = 0;
        std::optional<Cubic> cubic = {};
    };

    In<dvec2> part(std::size_t from, std::size_t to) const { return points_.subspan(from, to - from + 1); }

    Reach line_from(std::size_t from, std::size_t before) const {
        const auto reaches = [&](std::size_t to) { return is_straight(part(from, to), tolerance_); };
        return {farthest(from, from + 1, reaches), before};
    }

    Reach cubic_from(std::size_t from, std::size_t before) const {
        Reach reach{from, before};
        Tangents tangents = ends_;
        if (from > 0) tangents.start = tangent_at(points_, from);
        const auto reaches = [&](std::size_t to) {
            tangents.end = to < last_ ? std::optional(tangent_at(points_, to)) : ends_.end;
            const std::optional<Cubic> found = fit_cubic(part(from, to), tangents, tolerance_);
            if (found) reach.cubic = found;
            return found.has_value();
        };
        reach.to = farthest(from, from, reaches);
        return reach;
    }

    /// The farthest point for which `reaches` holds, as it does for `near`: all, or by doubled steps and then halved
    /// ones. All of a long line is tried after these steps, so that the time grows as its length.
    template <typename Reaches>
    std::size_t farthest(std::size_t from, std::size_t near, const Reaches& reaches) const {
        if (near == last_) return last_;
        const bool is_long = last_ - from > at_once;
        if (!is_long && reaches(last_)) return last_;
        std::size_t far = last_;
        for (std::size_t step = 2; near + step < last_; step *= 2) {
            if (!reaches(near + step)) {
                far = near + step;
                break;
            }
            near += step;
        }
        if (is_long && far == last_ && reaches(last_)) return last_;
        while (far - near > 1) {
            const std::size_t middle = near + (far - near) / 2;
            (reaches(middle) ? near : far) = middle;
        }
        return near;
    }

    In<dvec2> points_;
    std::size_t last_;
    double tolerance_;
    Tangents ends_;
    Curve& out_;
};

/// The point of a closed polyline, without its last one, where it turns least.
std::size_t flattest(const Points& points) {
    const std::size_t count = points.size();
    std::size_t best = 0;
    double least = -1.0;
    for (std::size_t i = 0; i < count; ++i) {
        const dvec2 a = points[i] - points[(i + count - 1) % count], b = points[(i + 1) % count] - points[i];
        const double straight = glm::dot(a, b) / (glm::length(a) * glm::length(b));
        if (straight > least + 1e-9) {
            least = straight;
            best = i;
        }
    }
    return best;
}

Curve fit_closed(Points points, double tolerance) {
    std::vector<std::size_t> corners = Corners(points, true, tolerance).find();
    const std::size_t start = corners.empty() ? flattest(points) : corners[0];
    std::ranges::rotate(points, points.begin() + std::ptrdiff_t(start));
    Curve curve{{points[0]}, {}, true};
    const std::size_t count = points.size();
    points.push_back(points[0]);
    if (corners.empty()) {
        Points around(points.end() - 1 - std::ptrdiff_t(std::min(beside, count - 1)), points.end() - 1);
        const std::size_t middle = around.size();
        around.insert(around.end(), points.begin(), points.begin() + std::ptrdiff_t(std::min(beside + 1, count)));
        const dvec2 tangent = tangent_at(around, middle);
        Smooth(points, tolerance, {tangent, tangent}, curve).add();
        return curve;
    }
    corners.push_back(start + count);
    for (std::size_t k = 0; k + 1 < corners.size(); ++k)
        Smooth(In<dvec2>(points).subspan(corners[k] - start, corners[k + 1] - corners[k] + 1), tolerance, {}, curve)
            .add();
    return curve;
}

}  // namespace

Curve fit(In<dvec2> points, bool closed, double tolerance) {
    Points kept = distinct(points, same * tolerance);
    if (kept.size() < 2) return {};
    if (closed && kept.front() == kept.back() && kept.size() > 3) {
        if (tolerance <= 0.0) return Curve::through(kept, true);
        kept.pop_back();
        return fit_closed(std::move(kept), for_points * tolerance);
    }
    if (tolerance <= 0.0) return Curve::through(kept, false);
    const double bound = for_points * tolerance;
    std::vector<std::size_t> corners = Corners(kept, false, bound).find();
    corners.push_back(kept.size() - 1);
    Curve curve{{kept[0]}, {}, false};
    std::size_t from = 0;
    for (const std::size_t to : corners) {
        Smooth(In<dvec2>(kept).subspan(from, to - from + 1), bound, {}, curve).add();
        from = to;
    }
    return curve;
}

}  // namespace fovea::vector
