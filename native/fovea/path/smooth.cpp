// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/smooth.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/mesh/triangle_sides.h>

namespace fovea::path {
namespace {

/// Weighted least-squares fit of a parabola in s; solve() gives its value and slope at s = 0.
struct Fit {
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
    /// False if there are fewer than 5 points or the fit is ill-conditioned.
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

/// Smooths one chain.
class Smoother {
   public:
    Smoother(CurveChains& chains, Index chain, const Surface& surface, const TriangleSides& sides,
             const Smoothing& options)
        : chains_(chains), first_(chains.rows.begin(chain)), closed_(chains.closed[chain]), options_(options) {
        const Index points = chains.rows.size(chain);
        count_ = int(closed_ ? points - 1 : points);
        on_.resize(count_);
        for (int i = 0; i < count_; ++i) {
            const Index side = chains.side[first_ + i];
            if (side == none) continue;
            On& on = on_[i];
            on.from = dvec3(surface.positions[sides.vertices[side].x]);
            on.along = dvec3(surface.positions[sides.vertices[side].y]) - on.from;
            const double square = glm::dot(on.along, on.along);
            if (!(square > 0.0)) continue;
            on.t = on.t0 = glm::dot(dvec3(chains.point[first_ + i]) - on.from, on.along) / square;
            on.fixed = !closed_ && (i == 0 || i + 1 == count_);
        }
    }

    /// Moves points along their sides, then averages strength.
    void run() {
        if (count_ < 5) return;
        for (int round = 0; round < options_.rounds; ++round) move_all([&](int i) { return fitted_on_side(i); });
        measure();
        average_strength();
        if (closed_) chains_.strength[first_ + count_] = chains_.strength[first_];
    }

    /// Moves points freely, close to where they are now.
    void run_free() {
        if (count_ < 5) return;
        std::vector<dvec3> start(count_);
        for (int i = 0; i < count_; ++i) start[i] = point(i);
        for (int round = 0; round < options_.rounds; ++round) move_all([&](int i) { return fitted_near(i, start[i]); });
    }

   private:
    struct On {
        dvec3 from{0}, along{0};
        double t = 0.0, t0 = 0.0;
        bool fixed = true;
    };

    template <typename Fitted>
    void move_all(const Fitted& fitted) {
        measure();
        std::vector<dvec3> moved(count_);
        for (int i = 0; i < count_; ++i) moved[i] = on_[i].fixed ? point(i) : fitted(i);
        for (int i = 0; i < count_; ++i) chains_.point[first_ + i] = vec3(moved[i]);
        if (closed_) chains_.point[first_ + count_] = chains_.point[first_];
    }

    /// Wraps an index that is less than one period out of range.
    int wrapped(int i) const { return i < 0 ? i + count_ : i < count_ ? i : i - count_; }
    dvec3 point(int i) const { return dvec3(chains_.point[first_ + i]); }

    /// Measures segments, and the mean length of sides near each point, which scales windows: lines bend more sharply
    /// where the mesh is finer.
    void measure() {
        constexpr int near = 4;
        length_.resize(count_);
        unit_.resize(count_);
        total_ = 0.0;
        double sum = 0.0;
        int sides = 0;
        const auto count_side = [&](int i, int sign) {
            if (!closed_ && (i < 0 || i >= count_)) return;
            const double length = glm::length(on_[wrapped(i)].along);
            if (length > 0.0) {
                sum += sign * length;
                sides += sign;
            }
        };
        for (int i = -near; i < near; ++i) count_side(i, 1);
        for (int i = 0; i < count_; ++i) {
            count_side(i + near, 1);
            const bool last = !closed_ && i + 1 == count_;
            unit_[i] = sides > 0 ? sum / sides : 0.0;
            length_[i] = last ? 0.0 : glm::distance(point(i), point(wrapped(i + 1)));
            total_ += length_[i];
            count_side(i - near, -1);
        }
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

    /// Biweight kernel; `s` in units of the window.
    static double kernel(double s) {
        const double u = 1.0 - s * s;
        return u > 0.0 ? u * u : 0.0;
    }

    /// Value and slope, at point i, of the parabola fitted around it.
    bool fit_around(int i, dvec3& value, dvec3& slope) const {
        constexpr double least_share = 0.01;
        const double window = options_.window * unit_[i];
        Fit fit;
        const double per_window = window > 0.0 ? 1.0 / window : 0.0;
        around(i, window, [&](int j, double s, double share) {
            const double u = s * per_window;
            fit.add(u, kernel(u) * (share + least_share * window), point(j));
        });
        return fit.solve(value, slope);
    }

    dvec3 fitted_near(int i, const dvec3& start) const {
        constexpr double farthest = 0.1;
        dvec3 value, slope;
        if (!fit_around(i, value, slope)) return point(i);
        const dvec3 way = value - start;
        const double length = glm::length(way), most = farthest * unit_[i];
        return length > most ? start + most / length * way : value;
    }

    /// New position of point i: on its side, as close as possible to the fitted curve; the position along the curve has
    /// little weight.
    dvec3 fitted_on_side(int i) {
        constexpr double slide = 0.1, from_vertex = 1e-3;
        dvec3 value, slope;
        On& on = on_[i];
        if (!fit_around(i, value, slope)) return point(i);
        const double speed = glm::dot(slope, slope);
        const auto across = [&](const dvec3& x) { return speed > 0.0 ? x - glm::dot(x, slope) / speed * slope : x; };
        const dvec3 aim = value - on.from, aim_across = across(aim), along_across = across(on.along);
        const double weight = glm::dot(along_across, along_across) + slide * glm::dot(on.along, on.along);
        const double t = (glm::dot(along_across, aim_across) + slide * glm::dot(on.along, aim)) / weight;
        const double low = std::min(on.t0, from_vertex), high = std::max(on.t0, 1.0 - from_vertex);
        on.t = std::clamp(std::clamp(t, on.t0 - options_.tolerance, on.t0 + options_.tolerance), low, high);
        return on.from + on.t * on.along;
    }

    /// Averages strength. Windows shrink towards open ends, so that the ends keep their strength and lines fade out to
    /// it.
    void average_strength() {
        std::vector<float> mean(count_);
        double before = 0.0;
        for (int i = 0; i < count_; ++i) {
            const double wide = options_.window * unit_[i];
            const double window = closed_ ? wide : std::min({wide, before, total_ - before});
            double sum = 0.0, weights = 0.0;
            if (window > 0.0)
                around(i, window, [&](int j, double s, double share) {
                    const double weight = kernel(s / window) * share;
                    sum += weight * chains_.strength[first_ + j];
                    weights += weight;
                });
            mean[i] = weights > 0.0 ? static_cast<float>(sum / weights) : chains_.strength[first_ + i];
            before += length_[i];
        }
        std::copy(mean.begin(), mean.end(), chains_.strength.begin() + first_);
    }

    CurveChains& chains_;
    Index first_;
    bool closed_;
    const Smoothing options_;
    int count_ = 0;
    std::vector<On> on_;
    std::vector<double> length_, unit_;  // per point: length of the segment from it; mean length of sides near it
    double total_ = 0.0;
};

}  // namespace

void smooth(CurveChains& chains, const Surface& surface, const Smoothing& options) {
    const auto sides = triangle_sides(surface);
    parallel_for(chains.rows.count(), 16,
                 [&](std::size_t c) { Smoother(chains, static_cast<Index>(c), surface, *sides, options).run(); });
}

void lift(CurveChains& chains, const Surface& surface, In<Curvature> curvature) {
    constexpr float farthest = 0.1f, least_cosine = 0.5f;
    const auto sides = triangle_sides(surface);
    parallel_for(chains.point.size(), [&](std::size_t i) {
        if (chains.side[i] == none) return;
        const Edge e = sides->vertices[chains.side[i]];
        const vec3 along = surface.positions[e.y] - surface.positions[e.x];
        const vec3 &n0 = curvature[e.x].normal, &n1 = curvature[e.y].normal;
        const float length = glm::length(along);
        if (!(glm::dot(n0, n1) >= least_cosine) || !(length > 0.0f)) return;
        const float t = glm::dot(chains.point[i] - surface.positions[e.x], along) / (length * length);
        const float s = 1.0f - t, w0 = -glm::dot(along, n0), w1 = glm::dot(along, n1);
        vec3 rise = t * s * (s * w0 * n0 + t * w1 * n1);
        const float high = glm::length(rise);
        if (high > farthest * length) rise *= farthest * length / high;
        chains.point[i] += rise;
    });
    parallel_for(chains.rows.count(), 16,
                 [&](std::size_t c) { Smoother(chains, static_cast<Index>(c), surface, *sides, {}).run_free(); });
}

}  // namespace fovea::path
