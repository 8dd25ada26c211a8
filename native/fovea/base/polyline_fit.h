// SPDX-License-Identifier: GPL-3.0-or-later
// Parabolas fitted along polylines: what is left of a line without the zigzag of its points. Savitzky & Golay,
// "Smoothing and Differentiation of Data by Simplified Least Squares Procedures", 1964.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <fovea/base/types.h>

namespace fovea::base {

/// Local fits to the points of one polyline, as functions of arc length. Windows are measured in the sizes of what is
/// near a point, as lines bend more sharply where a mesh is finer. Linear time in the number of points.
class PolylineFit {
   public:
    /// `count`: distinct points, of a closed polyline without the repeated one.
    PolylineFit(int count, bool closed) : count_(count), closed_(closed) {}

    /// Measures the points' distances, and the mean of the sizes that are not 0 of the eight points around each.
    /// point(i): dvec3, size(i): double, for i in [0, count).
    template <typename Point, typename Size>
    void measure(const Point& point, const Size& size) {
        constexpr int near = 4;
        length_.resize(count_);
        unit_.resize(count_);
        total_ = 0.0;
        double sum = 0.0;
        int sizes = 0;
        const auto count_size = [&](int i, int sign) {
            if (!closed_ && (i < 0 || i >= count_)) return;
            const double length = size(wrapped(i));
            if (length > 0.0) {
                sum += sign * length;
                sizes += sign;
            }
        };
        for (int i = -near; i < near; ++i) count_size(i, 1);
        for (int i = 0; i < count_; ++i) {
            count_size(i + near, 1);
            const bool last = !closed_ && i + 1 == count_;
            unit_[i] = sizes > 0 ? sum / sizes : 0.0;
            length_[i] = last ? 0.0 : glm::distance(point(i), point(wrapped(i + 1)));
            total_ += length_[i];
            count_size(i - near, -1);
        }
    }

    /// As of the last measure(): the mean size around a point, the distance from it to the next one, their sum.
    double unit(int i) const { return unit_[i]; }
    double length(int i) const { return length_[i]; }
    double total() const { return total_; }

    /// Biweight kernel; `s` in units of the window.
    static double kernel(double s) {
        const double u = 1.0 - s * s;
        return u > 0.0 ? u * u : 0.0;
    }

    /// Calls visit(point, signed arc length from i, weight: half the length of its two segments) for point i and those
    /// less than `window` away.
    template <typename Visit>
    void around(int i, double window, const Visit& visit) const {
        const auto share = [&](int j) { return 0.5 * (length_[j] + length_[closed_ || j > 0 ? wrapped(j - 1) : j]); };
        window = closed_ ? std::min(window, 0.5 * total_) : window;
        visit(i, 0.0, share(i));
        double s = 0.0;
        for (int n = 1; n < count_ && (closed_ || i + n < count_); ++n) {
            s += length_[wrapped(i + n - 1)];
            if (s >= window) break;
            visit(wrapped(i + n), s, share(wrapped(i + n)));
        }
        s = 0.0;
        for (int n = 1; n < count_ && (closed_ || i - n >= 0); ++n) {
            s -= length_[wrapped(i - n)];
            if (-s >= window) break;
            visit(wrapped(i - n), s, share(wrapped(i - n)));
        }
    }

    /// Value and slope, at point i, of the parabola fitted to the points less than `sizes` of the sizes there away.
    /// False if there are fewer than 5 points or the fit is ill-conditioned.
    template <typename Point>
    bool at(int i, double sizes, const Point& point, dvec3& value, dvec3& slope) const {
        constexpr double least_share = 0.01;
        const double window = sizes * unit_[i];
        Parabola fit;
        const double per_window = window > 0.0 ? 1.0 / window : 0.0;
        around(i, window, [&](int j, double s, double share) {
            const double u = s * per_window;
            fit.add(u, kernel(u) * (share + least_share * window), point(j));
        });
        return fit.solve(value, slope);
    }

   private:
    /// Weighted least-squares fit of a parabola in s; solve() gives its value and slope at s = 0.
    struct Parabola {
        double moment[5] = {0, 0, 0, 0, 0};  // weighted sums of s^k
        dvec3 sum[3] = {dvec3(0), dvec3(0), dvec3(0)};
        int count = 0;

        void add(double s, double weight, const dvec3& x) {
            ++count;
            for (int k = 0; k < 5; ++k, weight *= s) {
                moment[k] += weight;
                if (k < 3) sum[k] += weight * x;
            }
        }
        bool solve(dvec3& value, dvec3& slope) const {
            const dmat3 m(moment[0], moment[1], moment[2], moment[1], moment[2], moment[3], moment[2], moment[3],
                          moment[4]);
            if (count < 5 || !(std::abs(glm::determinant(m)) > 1e-6 * moment[0] * moment[2] * moment[4])) return false;
            const dmat3 inverse = glm::inverse(m);
            value = inverse[0][0] * sum[0] + inverse[1][0] * sum[1] + inverse[2][0] * sum[2];
            slope = inverse[0][1] * sum[0] + inverse[1][1] * sum[1] + inverse[2][1] * sum[2];
            return true;
        }
    };

    /// Wraps an index that is less than one period out of range.
    int wrapped(int i) const { return i < 0 ? i + count_ : i < count_ ? i : i - count_; }

    int count_;
    bool closed_;
    std::vector<double> length_, unit_;
    double total_ = 0.0;
};

}  // namespace fovea::base
