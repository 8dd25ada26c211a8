// SPDX-License-Identifier: GPL-3.0-or-later
// Points by cells of a square grid, to find those near a place.
#pragma once

#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

#include <fovea/base/types.h>

namespace fovea::base {

class PointGrid {
   public:
    /// `most`: in a cell; those beyond it are not kept, so that points in one place cost no more than others.
    explicit PointGrid(double cell, std::size_t most = std::numeric_limits<std::size_t>::max())
        : cell_(cell), most_(most) {}

    void add(const dvec2& point, std::size_t number) {
        std::vector<std::size_t>& there = cells_[key(cell_of(point))];
        if (there.size() < most_) there.push_back(number);
    }

    /// Calls visit(number) for all numbers in cells at most `rings` away from that of a point, or exactly so far.
    template <typename Visit>
    void near(const dvec2& point, const Visit& visit, int rings = 1) const {
        for (int ring = 0; ring <= rings; ++ring) at_ring(point, ring, visit);
    }
    template <typename Visit>
    void at_ring(const dvec2& point, int ring, const Visit& visit) const {
        const glm::i64vec2 middle = cell_of(point);
        for (int y = -ring; y <= ring; ++y)
            for (int x = -ring; x <= ring; x += std::abs(y) == ring || ring == 0 ? 1 : 2 * ring)
                if (const auto found = cells_.find(key(middle + glm::i64vec2(x, y))); found != cells_.end())
                    for (const std::size_t number : found->second) visit(number);
    }

    double cell() const { return cell_; }

   private:
    glm::i64vec2 cell_of(const dvec2& p) const { return {std::floor(p.x / cell_), std::floor(p.y / cell_)}; }
    static std::uint64_t key(const glm::i64vec2& cell) {
        return std::uint64_t(cell.x) << 32 ^ (std::uint64_t(cell.y) & 0xffffffffu);
    }

    double cell_;
    std::size_t most_;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;  // never walked through: its order is nobody's
};

}  // namespace fovea::base
