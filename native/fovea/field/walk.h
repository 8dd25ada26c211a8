// SPDX-License-Identifier: GPL-3.0-or-later
// Breadth-first traversal of the rings around a vertex.
#pragma once

#include <algorithm>
#include <vector>

#include <fovea/field/neighbors.h>

namespace fovea::field {

/// One instance per thread: visited marks are stamps, so nothing has to be cleared between traversals.
class Walk {
   public:
    explicit Walk(Index vertices) : seen_(vertices, 0) {}

    /// Vertices within `rings` of v: v first, then ring by ring. Adds up to `extra_rings` more rings while there are
    /// fewer than `enough` vertices. Does not continue past vertices on hard edges, except v itself. Valid until the
    /// next call.
    const std::vector<Index>& gather(const Neighbors& neighbors, Index v, int rings, std::size_t enough = 0,
                                     int extra_rings = 0) {
        if (++stamp_ == 0) {
            std::fill(seen_.begin(), seen_.end(), 0);
            stamp_ = 1;
        }
        found_.clear();
        found_.push_back(v);
        seen_[v] = stamp_;
        std::size_t begin = 0;
        for (int ring = 0; ring < rings || (ring < rings + extra_rings && found_.size() < enough); ++ring) {
            const std::size_t end = found_.size();
            if (begin == end) break;
            for (; begin < end; ++begin) {
                const Index from = found_[begin];
                if (from != v && neighbors.hard[from]) continue;
                for (const Index to : neighbors.vertices[from]) {
                    if (seen_[to] == stamp_) continue;
                    seen_[to] = stamp_;
                    found_.push_back(to);
                }
            }
        }
        return found_;
    }

   private:
    Array<Index> seen_;
    Index stamp_ = 0;
    std::vector<Index> found_;
};

}  // namespace fovea::field
