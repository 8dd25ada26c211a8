// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/outline.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/elementary.h>
#include <fovea/stroke/strip.h>
#include <fovea/vector/fit.h>
#include <fovea/vector/fit_cubic.h>

namespace fovea::vector {
namespace {

constexpr double straight = 0.995;        // cosine of a bend that needs no room
constexpr double kept_share = 0.98;       // of half the width; points of a side that are nearer to the line are inside
constexpr double quarter = 0.5522847498;  // handles of a cubic for a quarter of a circle, in radii
constexpr double half = 4.0 / 3.0;        // and for half of one,
constexpr double half_off = 0.0185;       // which is that far beside it
constexpr int steps_beside = 4;           // points at either end of a side before a bend, half a radius apart

dvec2 left_of(const dvec2& d) { return {-d.y, d.x}; }

/// A polyline with half its width at each point.
struct Ribbon {
    Points points;
    std::vector<double> radii;
    bool closed = false;

    std::size_t size() const { return points.size(); }
    dvec2 direction(std::size_t i) const { return glm::normalize(points[i + 1] - points[i]); }
    /// Directions before and after a point; equal at an end.
    dvec2 into(std::size_t i) const { return i > 0 ? direction(i - 1) : direction(closed ? size() - 2 : 0); }
    dvec2 out_of(std::size_t i) const {
        return i + 1 < size() ? direction(i) : closed ? direction(0) : direction(i - 1);
    }
    void push(const dvec2& point, double radius) {
        if (!points.empty() && glm::distance(points.back(), point) < 1e-9) return;
        points.push_back(point);
        radii.push_back(radius);
    }
};

/// The same with points beside bends, so that of the inner sides there only what lies inside is left out.
Ribbon refined(const Ribbon& line) {
    Ribbon fine{{}, {}, line.closed};
    const auto bends = [&](std::size_t i) { return glm::dot(line.into(i), line.out_of(i)) < straight; };
    fine.push(line.points[0], line.radii[0]);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double length = glm::distance(line.points[i], line.points[i + 1]);
        std::vector<double> at;
        for (int k = 1; k <= steps_beside; ++k) {
            if (bends(i)) at.push_back(0.5 * k * line.radii[i] / length);
            if (bends(i + 1)) at.push_back(1.0 - 0.5 * k * line.radii[i + 1] / length);
        }
        std::ranges::sort(at);
        for (const double t : at)
            if (t > 0.0 && t < 1.0)
                fine.push(glm::mix(line.points[i], line.points[i + 1], t),
                          glm::mix(line.radii[i], line.radii[i + 1], t));
        fine.push(line.points[i + 1], line.radii[i + 1]);
    }
    return fine;
}

class Side {
   public:
    /// `side`: 1 on the left of the line, -1 on its right.
    Side(const Ribbon& line, double side) : line_(line), side_(side) {}

    Points points() {
        for (std::size_t i = 0; i < line_.size(); ++i) add(i);
        if (out_.size() < 2) out_ = {line_.points.front(), line_.points.back()};
        if (line_.closed) out_.back() = out_.front();
        return std::move(out_);
    }

   private:
    dvec2 square(std::size_t i, const dvec2& direction) const {
        return line_.points[i] + side_ * line_.radii[i] * left_of(direction);
    }

    void add(std::size_t i) {
        const dvec2 a = line_.into(i), b = line_.out_of(i);
        const double along = glm::dot(a, b);
        const bool inner = side_ * cross(a, b) > 0.0, is_end = !line_.closed && (i == 0 || i + 1 == line_.size());
        if (is_end) return out_.push_back(square(i, a));
        if (along < stroke::mitre_limit) {
            if (!inner) add_arc(i, a, b);
            return;
        }
        const dvec2 corner = line_.points[i] + side_ * line_.radii[i] * left_of(a + b) / (1.0 + along);
        if (!inner || is_outside(corner, i)) out_.push_back(corner);
    }

    /// Whether a point of this side is not nearer to another part of the line than that is wide.
    bool is_outside(const dvec2& p, std::size_t i) const {
        const auto is_near = [&](std::size_t k) {
            const double radius = kept_share * std::min(line_.radii[k], line_.radii[k + 1]);
            return distance_to_segment(p, line_.points[k], line_.points[k + 1]) < radius;
        };
        const double reach = 4.0 * line_.radii[i];
        double way = 0.0;
        for (std::size_t k = i; k-- > 0 && way < reach; way += glm::distance(line_.points[k], line_.points[k + 1]))
            if (is_near(k)) return false;
        way = 0.0;
        for (std::size_t k = i; k + 1 < line_.size() && way < reach; ++k) {
            if (is_near(k)) return false;
            way += glm::distance(line_.points[k], line_.points[k + 1]);
        }
        return true;
    }

    void add_arc(std::size_t i, const dvec2& a, const dvec2& b) {
        constexpr int steps = 12;
        const double angle = arc_cosine(std::clamp(glm::dot(a, b), -1.0, 1.0));
        for (int k = 0; k <= steps; ++k) {
            const double turned = -side_ * angle * k / steps, c = cosine(turned), s = sine(turned);
            out_.push_back(square(i, {a.x * c - a.y * s, a.x * s + a.y * c}));
        }
    }

    const Ribbon& line_;
    double side_;
    Points out_;
};

/// From the curve's end around the end of a line to `to`, within `tolerance`: its direction there, outwards.
void cap(Curve& curve, const dvec2& to, const dvec2& direction, bool round, double tolerance) {
    if (!round) return curve.line_to(to);
    const dvec2 from = curve.end(), middle = 0.5 * (from + to), side = 0.5 * (from - to);
    const dvec2 out = glm::length(side) * direction;
    if (half_off * glm::length(side) <= tolerance) return curve.cubic_to(from + half * out, to + half * out, to);
    const dvec2 tip = middle + out, handle = quarter * out;
    curve.cubic_to(from + handle, tip + quarter * side, tip);
    curve.cubic_to(tip - quarter * side, to + handle, to);
}

}  // namespace

std::vector<Curve> outline(In<dvec2> points, In<double> widths, bool closed, RoundEnds round, double tolerance) {
    Ribbon line{{}, {}, closed};
    for (std::size_t i = 0; i < points.size(); ++i) line.push(points[i], 0.5 * widths[i]);
    if (line.size() < 2 || (closed && line.size() < 4)) return {};
    if (closed) line.points.back() = line.points.front();
    const Ribbon fine = refined(line);
    Points left = Side(fine, 1.0).points(), right = Side(fine, -1.0).points();
    std::ranges::reverse(right);
    if (closed) {
        std::vector<Curve> both{fit(left, true, tolerance), fit(right, true, tolerance)};
        std::erase_if(both, [](const Curve& c) { return c.empty(); });
        return both;
    }
    Curve curve = fit(left, false, tolerance);
    const Curve back = fit(right, false, tolerance);
    if (curve.empty() || back.empty()) return {};
    cap(curve, back.start(), fine.direction(fine.size() - 2), round.end, tolerance);
    curve.append(back);
    cap(curve, curve.start(), -fine.direction(0), round.start, tolerance);
    curve.closed = true;
    return {curve};
}

}  // namespace fovea::vector
