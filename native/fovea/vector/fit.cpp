// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/fit.h>

#include <algorithm>
#include <cmath>

#include <fovea/vector/fit_cubic.h>

namespace fovea::vector {
namespace {

constexpr double same = 1e-3;         // tolerances; points that near are one
constexpr double sharp = 0.87;        // cosine of the turn of a corner: 30 degrees
constexpr double look = 6.0;          // tolerances over which directions are measured
constexpr double most_rise = 14.0;    // tolerances; a smooth curve is a 14th of the side times the turn beside it
constexpr double for_points = 0.9;    // of the tolerance: the rest is for points that are left out
constexpr std::size_t few_sides = 2;  // of a polyline, which have fewer numbers than a cubic
constexpr std::size_t at_once = 200;  // points that one cubic is tried for first
constexpr std::size_t beside = 3;     // points to each side of a joint that tell its tangent

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

/// Fits a part of a polyline without corners.
class Smooth {
   public:
    Smooth(In<dvec2> points, double tolerance, Curve& out) : points_(points), tolerance_(tolerance), out_(out) {}

    void add(const Tangents& ends) {
        if (is_straight(points_, tolerance_)) return out_.line_to(points_.back());
        std::optional<dvec2> direction = ends.start;
        for (std::size_t from = 0; from + 1 < points_.size();) {
            const std::size_t to = farthest(from, {direction, ends.end});
            // Lines where they are fewer numbers, and where no cubic goes even to the next point.
            if (!best_ || is_straight(part(from, to), 0.5 * tolerance_))
                out_.line_to(points_[to]);
            else if (to - from <= few_sides)
                for (std::size_t i = from + 1; i <= to; ++i) out_.line_to(points_[i]);
            else
                out_.cubic_to((*best_)[1], (*best_)[2], (*best_)[3]);
            direction = best_ ? std::optional(tangent_at(points_, to)) : std::nullopt;
            from = to;
        }
    }

   private:
    In<dvec2> part(std::size_t from, std::size_t to) const { return points_.subspan(from, to - from + 1); }

    bool reaches(std::size_t from, std::size_t to, const Tangents& ends) {
        Tangents tangents = ends;
        if (to + 1 < points_.size()) tangents.end = tangent_at(points_, to);
        const std::optional<Cubic> found = fit_cubic(part(from, to), tangents, tolerance_);
        if (found) best_ = found;
        return found.has_value();
    }

    /// The farthest point that one cubic reaches, which is kept: all, or by doubled steps and then halved ones. All of
    /// a long line is tried after these steps, so that the time grows as its length.
    std::size_t farthest(std::size_t from, const Tangents& ends) {
        best_.reset();
        const std::size_t last = points_.size() - 1;
        const bool is_long = last - from > at_once;
        if (!is_long && reaches(from, last, ends)) return last;
        std::size_t near = from + 1, far = last, step = 2;
        reaches(from, near, ends);
        while (near + step < last) {
            if (!reaches(from, near + step, ends)) {
                far = near + step;
                break;
            }
            near += step;
            step *= 2;
        }
        if (is_long && far == last && reaches(from, last, ends)) return last;
        while (far - near > 1) {
            const std::size_t middle = near + (far - near) / 2;
            (reaches(from, middle, ends) ? near : far) = middle;
        }
        return near;
    }

    In<dvec2> points_;
    double tolerance_;
    Curve& out_;
    std::optional<Cubic> best_;
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
        Smooth(points, tolerance, curve).add({tangent, tangent});
        return curve;
    }
    corners.push_back(start + count);
    for (std::size_t k = 0; k + 1 < corners.size(); ++k)
        Smooth(In<dvec2>(points).subspan(corners[k] - start, corners[k + 1] - corners[k] + 1), tolerance, curve)
            .add({});
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
        Smooth(In<dvec2>(kept).subspan(from, to - from + 1), bound, curve).add({});
        from = to;
    }
    return curve;
}

}  // namespace fovea::vector
