// SPDX-License-Identifier: GPL-3.0-or-later
// Union-find.
#pragma once

#include <algorithm>
#include <numeric>

#include <fovea/base/types.h>

namespace fovea::base {

/// Disjoint sets of the numbers below a count. A set is named by its least member, so that the order of joins does not
/// matter.
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
