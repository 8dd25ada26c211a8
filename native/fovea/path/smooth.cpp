// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/smooth.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/base/polyline_fit.h>
#include <fovea/mesh/triangle_sides.h>

namespace fovea::path {
namespace {

/// Smooths one chain.
class Smoother {
   public:
    Smoother(CurveChains& chains, Index chain, const Surface& surface, const TriangleSides& sides,
             const Smoothing& options)
        : chains_(chains),
          first_(chains.rows.begin(chain)),
          closed_(chains.closed[chain]),
          options_(options),
          count_(int(chains.rows.size(chain)) - (closed_ ? 1 : 0)),
          fit_(count_, closed_),
          on_(count_) {
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

    dvec3 point(int i) const { return dvec3(chains_.point[first_ + i]); }

    /// Sizes are the lengths of sides.
    void measure() {
        fit_.measure([&](int i) { return point(i); }, [&](int i) { return glm::length(on_[i].along); });
    }

    bool fit_around(int i, dvec3& value, dvec3& slope) const {
        return fit_.at(i, options_.window, [&](int j) { return point(j); }, value, slope);
    }

    dvec3 fitted_near(int i, const dvec3& start) const {
        constexpr double farthest = 0.1;
        dvec3 value, slope;
        if (!fit_around(i, value, slope)) return point(i);
        const dvec3 way = value - start;
        const double length = glm::length(way), most = farthest * fit_.unit(i);
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
            const double wide = options_.window * fit_.unit(i);
            const double window = closed_ ? wide : std::min({wide, before, fit_.total() - before});
            double sum = 0.0, weights = 0.0;
            if (window > 0.0)
                fit_.around(i, window, [&](int j, double s, double share) {
                    const double weight = PolylineFit::kernel(s / window) * share;
                    sum += weight * chains_.strength[first_ + j];
                    weights += weight;
                });
            mean[i] = weights > 0.0 ? static_cast<float>(sum / weights) : chains_.strength[first_ + i];
            before += fit_.length(i);
        }
        std::copy(mean.begin(), mean.end(), chains_.strength.begin() + first_);
    }

    CurveChains& chains_;
    Index first_;
    bool closed_;
    const Smoothing options_;
    int count_;
    PolylineFit fit_;
    std::vector<On> on_;
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
