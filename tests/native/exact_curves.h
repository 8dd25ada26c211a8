// SPDX-License-Identifier: GPL-3.0-or-later
// Curves where a function of exact curvature is zero, on surfaces known in closed form. Shares nothing with the tracing
// that it judges but the formulas for a point: a fine grid of the parameters, and a root search along its sides.
#pragma once

#include <array>
#include <optional>

#include <fovea/base/parallel.h>

#include "analytic.h"

namespace fovea::analytic {
using namespace draw;

struct ExactSegment {
    dvec3 a, b;
};
using ExactCurves = std::vector<ExactSegment>;

inline double length(const ExactCurves& curves) {
    double sum = 0.0;
    for (const ExactSegment& s : curves) sum += glm::distance(s.a, s.b);
    return sum;
}

/// Value of a function at a point, and the tangent that it is taken along: turning that around turns the value around,
/// unless `one_way`. Zero where the value depends on no such direction.
struct Along {
    double value = 0.0;
    dvec3 direction{0.0};
    bool one_way = false;

    /// As seen from a place nearby; nothing where the directions differ by more than 45 degrees.
    std::optional<double> as_at(const Along& near) const {
        if (direction == dvec3(0)) return value;
        const double cosine = glm::dot(glm::normalize(direction), glm::normalize(near.direction));
        if (!(std::abs(cosine) > std::sqrt(0.5)) || (one_way && cosine < 0)) return {};
        return cosine < 0 ? -value : value;
    }
};

/// Points of a surface with their curvature, over n x n cells of the parameters. An odd number: planes of symmetry,
/// where values are zero but for rounding, then pass between the nodes.
struct ExactGrid {
    const Sample& sample;
    int n;
    std::vector<dvec3> point{std::size_t(n + 1) * (n + 1)};
    std::vector<CurvatureD> curvature{point.size()};

    explicit ExactGrid(const Sample& of, int cells = 509) : sample(of), n(cells) {
        parallel_for(point.size(), [&](std::size_t k) {
            const dvec2 uv = parameters(k);
            point[k] = sample.point(uv.x, uv.y);
            curvature[k] = sample.exact(point[k]);
        });
    }
    dvec2 parameters(std::size_t k) const { return dvec2(double(k % (n + 1)), double(k / (n + 1))) / double(n); }
};

/// Traces each cell as two triangles. `at(point, curvature)`: Along; `margin(point)`: positive on what is kept.
template <typename At, typename Margin>
class ExactTrace {
   public:
    ExactTrace(const ExactGrid& grid, const At& at, const Margin& margin)
        : grid_(grid), n_(grid.n), at_(at), margin_(margin), values_(grid.point.size()) {}

    ExactCurves run() {
        parallel_for(values_.size(), [&](std::size_t k) { values_[k] = at_(grid_.point[k], grid_.curvature[k]); });
        std::vector<ExactCurves> rows(n_);
        parallel_for(n_, 8, [&](std::size_t j) {
            for (int i = 0; i < n_; ++i) {
                const int a = int(j) * (n_ + 1) + i, b = a + 1, c = b + n_ + 1, d = a + n_ + 1;
                add({a, b, c}, rows[j]);
                add({a, c, d}, rows[j]);
            }
        });
        ExactCurves curves;
        for (const ExactCurves& row : rows) curves.insert(curves.end(), row.begin(), row.end());
        return curves;
    }

   private:
    dvec3 place(const dvec2& uv) const { return grid_.sample.point(uv.x, uv.y); }
    Along along(const dvec2& uv) const {
        const dvec3 p = place(uv);
        return at_(p, grid_.sample.exact(p));
    }

    void add(const std::array<int, 3>& corners, ExactCurves& out) const {
        std::optional<double> value[3];
        for (int i = 0; i < 3; ++i) {
            value[i] = values_[corners[i]].as_at(values_[corners[0]]);
            for (int j = 0; j < i; ++j)
                if (!values_[corners[i]].as_at(values_[corners[j]])) return;
            if (!value[i]) return;
        }
        dvec3 ends[2];
        int count = 0;
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            if ((*value[i] >= 0) != (*value[j] >= 0))
                ends[count++] = root(grid_.parameters(corners[i]), grid_.parameters(corners[j]));
        }
        if (count == 2) trim(ends[0], ends[1], out);
    }

    /// Where the value is zero between two places of unlike sign.
    dvec3 root(dvec2 from, dvec2 to) const {
        const Along start = along(from);
        const bool positive = start.value >= 0;
        for (int step = 0; step < 26; ++step) {
            const dvec2 middle = 0.5 * (from + to);
            const auto value = along(middle).as_at(start);
            (value && (*value >= 0) == positive ? from : to) = middle;
        }
        return place(0.5 * (from + to));
    }

    void trim(dvec3 a, dvec3 b, ExactCurves& out) const {
        const double ma = margin_(a), mb = margin_(b);
        if (!(ma > 0) && !(mb > 0)) return;
        const dvec3 whole = b - a;
        if (!(ma > 0)) a += ma / (ma - mb) * whole;
        if (!(mb > 0)) b -= mb / (mb - ma) * whole;
        out.push_back({a, b});
    }

    const ExactGrid& grid_;
    const int n_;
    const At& at_;
    const Margin& margin_;
    std::vector<Along> values_;
};

}  // namespace fovea::analytic
