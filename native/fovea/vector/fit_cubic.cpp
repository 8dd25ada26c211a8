// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/fit_cubic.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fovea::vector {
namespace {

constexpr int most_rounds = 12;        // of reparametrization
constexpr double hopeless = 30.0;      // tolerances; a first fit that is farther off does not come near
constexpr double least_gain = 0.95;    // of the error in a round
constexpr double chord_share = 0.1;    // of the tolerance, between the cubic and its chords
constexpr double least_handle = 1e-3;  // of the polyline's length, and the most: shorter and longer ones make cusps
constexpr double most_handle = 1.5;

/// A free number: how far control point 1 lies in a direction from point 0, or point 2 from point 3.
struct Unknown {
    int control;
    dvec2 direction;
    double rest;  ///< its value at a third of the length
};

using Numbers = std::array<double, 4>;

/// Solves the first `count` of four symmetric positive definite equations by elimination.
Numbers solved(std::array<Numbers, 4> a, Numbers b, int count) {
    for (int i = 0; i < count; ++i)
        for (int k = i + 1; k < count; ++k) {
            const double factor = a[k][i] / a[i][i];
            for (int j = i; j < count; ++j) a[k][j] -= factor * a[i][j];
            b[k] -= factor * b[i];
        }
    for (int i = count - 1; i >= 0; --i) {
        for (int j = i + 1; j < count; ++j) b[i] -= a[i][j] * b[j];
        b[i] /= a[i][i];
    }
    return b;
}

class Fit {
   public:
    Fit(In<dvec2> points, const Tangents& tangents) : points_(points), place_(points.size()), weight_(points.size()) {
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double step = glm::distance(points[i - 1], points[i]);
            place_[i] = place_[i - 1] + step;
            weight_[i - 1] += 0.5 * step;
            weight_[i] += 0.5 * step;
        }
        length_ = place_.back();
        for (double& u : place_) u /= length_;
        place_.back() = 1.0;
        add_unknowns(1, tangents.start, 1.0);
        add_unknowns(2, tangents.end, -1.0);
    }

    /// The cubic nearest to the points at their places.
    Cubic nearest() const {
        std::array<Numbers, 4> a{};
        Numbers b{};
        const dvec2 first = points_.front(), last = points_.back();
        // Next to nothing, so that few points have an answer, too: control points at thirds.
        const double rest = 1e-6 * length_;
        for (int j = 0; j < count_; ++j) {
            a[j][j] = rest;
            b[j] = rest * unknowns_[j].rest;
        }
        for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
            const double u = place_[i], v = 1.0 - u, shares[] = {3.0 * u * v * v, 3.0 * u * u * v};
            const dvec2 missing = points_[i] - (v * v * v + shares[0]) * first - (u * u * u + shares[1]) * last;
            for (int j = 0; j < count_; ++j) {
                const double weighted = weight_[i] * shares[unknowns_[j].control - 1];
                b[j] += weighted * glm::dot(unknowns_[j].direction, missing);
                for (int k = 0; k < count_; ++k)
                    a[j][k] += weighted * shares[unknowns_[k].control - 1] *
                               glm::dot(unknowns_[j].direction, unknowns_[k].direction);
            }
        }
        return with(solved(a, b, count_));
    }

    /// Moves the places of points one step of Newton's method towards those nearest to them. The largest distance.
    double reparametrize(const Cubic& c) {
        double worst = 0.0;
        for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
            const double u = place_[i];
            const dvec2 off = point_at(c, u) - points_[i], slope = slope_at(c, u);
            worst = std::max(worst, glm::length(off));
            const double change = glm::dot(off, slope), rate = glm::dot(slope, slope) + glm::dot(off, bend_at(c, u));
            if (rate > 0.0) place_[i] = std::clamp(u - change / rate, place_[i - 1], 1.0);
        }
        return worst;
    }

    /// Whether all of the cubic is that near to the polyline, beside which it runs by the points' places.
    bool stays_near(const Cubic& c, double tolerance) const {
        const double near = (1.0 - chord_share) * tolerance;
        const int steps = steps_of(c, chord_share * tolerance);
        std::size_t side = 0;
        for (int k = 0; k <= steps; ++k) {
            const double u = double(k) / steps;
            while (side + 2 < points_.size() && place_[side + 1] < u) ++side;
            if (off(point_at(c, u), side) > near) return false;
        }
        return true;
    }

    bool points_are_near(const Cubic& c, double tolerance) const {
        for (std::size_t i = 1; i + 1 < points_.size(); ++i)
            if (glm::distance(point_at(c, place_[i]), points_[i]) > tolerance) return false;
        return true;
    }

   private:
    void add_unknowns(int control, const std::optional<dvec2>& tangent, double sign) {
        const dvec2 chord = (points_.back() - points_.front()) / 3.0;
        const auto add = [&](const dvec2& direction, double rest) {
            unknowns_[count_++] = {control, sign * direction, rest};
        };
        if (tangent) return add(*tangent, length_ / 3.0);
        add({1.0, 0.0}, chord.x);
        add({0.0, 1.0}, chord.y);
    }

    Cubic with(const Numbers& values) const {
        Cubic c{points_.front(), points_.front(), points_.back(), points_.back()};
        int of_control[3] = {0, 0, 0};
        for (int j = 0; j < count_; ++j) ++of_control[unknowns_[j].control];
        for (int j = 0; j < count_; ++j) {
            const bool fixed = of_control[unknowns_[j].control] == 1;
            const double value =
                fixed ? std::clamp(values[j], least_handle * length_, most_handle * length_) : values[j];
            c[unknowns_[j].control] += value * unknowns_[j].direction;
        }
        return c;
    }

    /// Distance of a point from a side of the polyline and its neighbors.
    double off(const dvec2& point, std::size_t side) const {
        double nearest = std::numeric_limits<double>::infinity();
        const std::size_t last = std::min(side + 2, points_.size() - 1);
        for (std::size_t i = side > 0 ? side - 1 : 0; i < last; ++i)
            nearest = std::min(nearest, distance_to_segment(point, points_[i], points_[i + 1]));
        return nearest;
    }

    In<dvec2> points_;
    std::vector<double> place_, weight_;  // places: u of the cubic
    double length_ = 0.0;
    std::array<Unknown, 4> unknowns_{};
    int count_ = 0;
};

}  // namespace

double distance_to_segment(const dvec2& point, const dvec2& a, const dvec2& b) {
    const dvec2 way = b - a;
    const double square = glm::dot(way, way);
    const double share = square > 0.0 ? std::clamp(glm::dot(point - a, way) / square, 0.0, 1.0) : 0.0;
    return glm::distance(point, a + share * way);
}

std::optional<Cubic> fit_cubic(In<dvec2> points, const Tangents& tangents, double tolerance) {
    Fit fit(points, tangents);
    double before = hopeless * tolerance;
    for (int round = 0; round < most_rounds; ++round) {
        const Cubic c = fit.nearest();
        if (fit.points_are_near(c, tolerance) && fit.stays_near(c, tolerance)) return c;
        const double error = fit.reparametrize(c);
        if (!(error < before)) return std::nullopt;
        before = std::max(least_gain * error, tolerance);
    }
    return std::nullopt;
}

}  // namespace fovea::vector
