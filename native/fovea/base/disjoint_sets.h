// SPDX-License-Identifier: GPL-3.0-or-later
// Union-find.
#pragma once

#include <algorithm>
#include <numeric>

#include <fovea/base/types.h>

namespace fovea::base {

/// Disjoint sets of the integers [0, count). A set's representative is its least member, so it does not depend on the
/// order of joins. Path halving; no union by rank.
class DisjointSets {
   public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index(0)); }

    Index name(Index i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(Index a, Index b) {
        a = name(a);
        b = name(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

   private:
    Array<Index> parent_;
};

}  // namespace fovea::base
