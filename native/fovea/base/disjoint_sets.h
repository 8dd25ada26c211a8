// SPDX-License-Identifier: GPL-3.0-or-later
// Union-find.
#pragma once

#include <atomic>
#include <numeric>
#include <utility>

#include <fovea/base/types.h>

namespace fovea::base {

/// Disjoint sets of the integers [0, count). A set's representative is its least member, so it does not depend on the
/// order of joins. Threads may join and ask for names at the same time; a name is final once all joins that concern it
/// are done. Roots are linked by exchange, and paths halved (Jayanti & Tarjan, "A Randomized Concurrent Algorithm for
/// Disjoint Set Union", PODC 2016, with the order of the numbers for a random one); no union by rank.
class DisjointSets {
   public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index(0)); }

    Index name(Index i) {
        for (;;) {
            const Index parent = at(i).load(std::memory_order_relaxed);
            if (parent == i) return i;
            const Index above = at(parent).load(std::memory_order_relaxed);
            if (above == parent) return parent;
            at(i).store(above, std::memory_order_relaxed);  // an ancestor for good, whatever others do
            i = above;
        }
    }
    void join(Index a, Index b) {
        for (;;) {
            a = name(a);
            b = name(b);
            if (a == b) return;
            if (a < b) std::swap(a, b);
            Index root = a;
            if (at(a).compare_exchange_strong(root, b, std::memory_order_relaxed)) return;
        }
    }

   private:
    std::atomic_ref<Index> at(Index i) { return std::atomic_ref(parent_[i]); }

    Array<Index> parent_;
};

}  // namespace fovea::base
