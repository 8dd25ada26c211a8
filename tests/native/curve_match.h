// SPDX-License-Identifier: GPL-3.0-or-later
// How well curves that were found agree with exact ones.
#pragma once

#include <unordered_map>

#include <fovea/line/curves.h>

#include "exact_curves.h"

namespace fovea::analytic {
using namespace draw;

/// Nearest of many segments, up to a reach.
class NearSegments {
   public:
    NearSegments(ExactCurves segments, double reach) : segments_(std::move(segments)), reach_(reach) {
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            const auto low = cell(glm::min(segments_[i].a, segments_[i].b)),
                       high = cell(glm::max(segments_[i].a, segments_[i].b));
            each(low, high, [&](std::uint64_t key) { cells_[key].push_back(i); });
        }
    }

    /// In the tangent plane with the normal `n`, or 0 for all of it: chords of a mesh lie below its surface. `reach`
    /// where none is nearer.
    double distance(const dvec3& p, const dvec3& n) const {
        double least = reach_;
        each(cell(p - reach_), cell(p + reach_), [&](std::uint64_t key) {
            const auto it = cells_.find(key);
            if (it == cells_.end()) return;
            for (const std::size_t i : it->second) {
                const dvec3 a = segments_[i].a - p, d = segments_[i].b - segments_[i].a;
                const double square = glm::dot(d, d);
                const dvec3 to = a + (square > 0 ? std::clamp(-glm::dot(a, d) / square, 0.0, 1.0) : 0.0) * d;
                if (glm::length(to) < reach_) least = std::min(least, glm::length(to - glm::dot(to, n) * n));
            }
        });
        return least;
    }

   private:
    glm::ivec3 cell(const dvec3& p) const { return glm::ivec3(glm::floor(p / reach_)); }
    template <typename Visit>
    static void each(const glm::ivec3& low, const glm::ivec3& high, const Visit& visit) {
        for (int x = low.x; x <= high.x; ++x)
            for (int y = low.y; y <= high.y; ++y)
                for (int z = low.z; z <= high.z; ++z)
                    visit(std::uint64_t(x + (1 << 20)) << 42 | std::uint64_t(y + (1 << 20)) << 21 |
                          std::uint64_t(z + (1 << 20)));
    }

    ExactCurves segments_;
    double reach_;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

/// Distances in edges; lengths in object units; shares of a length.
struct Match {
    double median = 0, most = 0;  ///< half and nine tenths of what was found lie nearer to an exact curve
    double found = 0, exact = 0;  ///< lengths
    double covered = 1;           ///< share of the exact curves that has something found within `reach`
    double false_share = 0;       ///< share of what was found that has no exact curve within `reach`
};

inline ExactCurves segments_of(const Curves& curves) {
    ExactCurves segments;
    for (const CurvePiece& p : curves) segments.push_back({dvec3(p.point[0]), dvec3(p.point[1])});
    return segments;
}

/// Of the parts for whose middles `counts` holds. `reach` in edges.
template <typename Counts>
Match match(const Sample& sample, const ExactCurves& found, const ExactCurves& exact, double edge, double reach,
            const Counts& counts) {
    constexpr double far = 4.0;  // edges
    const NearSegments near_exact(exact, far * edge), near_found(found, far * edge);
    const auto distances = [&](const ExactCurves& curves, const NearSegments& others) {
        std::vector<std::pair<double, double>> list;  // distance, length
        for (const ExactSegment& s : curves) {
            const dvec3 middle = 0.5 * (s.a + s.b);
            if (counts(middle))
                list.push_back({others.distance(middle, sample.exact(middle).normal) / edge, glm::distance(s.a, s.b)});
        }
        std::sort(list.begin(), list.end());
        return list;
    };
    const auto of_found = distances(found, near_exact), of_exact = distances(exact, near_found);
    const auto sum = [](const auto& list, double up_to) {
        double length = 0;
        for (const auto& [d, l] : list)
            if (d <= up_to) length += l;
        return length;
    };
    Match m;
    m.found = sum(of_found, 2 * far);
    m.exact = sum(of_exact, 2 * far);
    if (m.exact > 0) m.covered = sum(of_exact, reach) / m.exact;
    if (m.found > 0) m.false_share = 1 - sum(of_found, reach) / m.found;
    double length = 0;
    for (const auto& [d, l] : of_found) {
        if (length < 0.5 * m.found) m.median = d;
        if (length < 0.9 * m.found) m.most = d;
        length += l;
    }
    return m;
}

}  // namespace fovea::analytic
