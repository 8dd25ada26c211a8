// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <vector>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/parallel.h>

namespace fovea::base {
namespace {

struct Join {
    Index a, b;
};

std::vector<Join> random_joins(std::mt19937& random, Index size, std::size_t count) {
    std::vector<Join> joins(count);
    for (Join& join : joins) join = {Index(random() % size), Index(random() % size)};
    return joins;
}

/// The least member of each number's set, by going over all joins until nothing changes.
std::vector<Index> least_members(Index size, const std::vector<Join>& joins) {
    std::vector<Index> least(size);
    std::iota(least.begin(), least.end(), Index(0));
    for (bool changed = true; changed;) {
        changed = false;
        for (const Join& join : joins) {
            const Index both = std::min(least[join.a], least[join.b]);
            changed |= least[join.a] != both || least[join.b] != both;
            least[join.a] = least[join.b] = both;
        }
    }
    return least;
}

std::vector<Index> names(DisjointSets& sets, Index size) {
    std::vector<Index> found(size);
    for (Index i = 0; i < size; ++i) found[i] = sets.name(i);
    return found;
}

TEST(DisjointSets, AreNamedByTheirLeastMembers) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const Index size = 1 + random() % 60;
        const auto joins = random_joins(random, size, random() % 80);
        DisjointSets sets(size);
        for (const Join& join : joins) sets.join(join.a, join.b);
        EXPECT_EQ(names(sets, size), least_members(size, joins));
    }
}

TEST(DisjointSets, JoinedByManyThreadsAreThoseOfOneThread) {
    std::mt19937 random(2);
    constexpr Index size = 20000;
    for (int trial = 0; trial < 20; ++trial) {
        // Of many small sets, and of one of nearly all; and of a long chain, whose joins all meet in one root.
        auto joins = random_joins(random, size, trial % 2 ? size / 2 : 2 * size);
        if (trial % 5 == 0)
            for (Index i = 0; i + 1 < size; ++i) joins.push_back({i + 1, i});
        DisjointSets alone(size), together(size);
        for (const Join& join : joins) alone.join(join.a, join.b);
        parallel_for(joins.size(), 1, [&](std::size_t k) {
            together.join(joins[k].a, joins[k].b);
            EXPECT_LE(together.name(joins[k].a), joins[k].a);
        });
        EXPECT_EQ(names(together, size), names(alone, size));
    }
}

}  // namespace
}  // namespace fovea::base
