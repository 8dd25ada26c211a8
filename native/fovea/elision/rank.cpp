// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/rank.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fovea/base/check.h>

namespace fovea {

Array<Index> rank_runs(const ClippedPaths& clipped, const Runs& runs, In<float> priority, In<std::uint64_t> id) {
    check_runs(clipped, runs);
    const Index paths = Index(priority.size());
    check(id.size() == paths, "rank: one priority and one id per path expected");
    check(clipped.path.empty() || std::ranges::max(clipped.path) < paths, "rank: the runs are of other paths");
    // Slot 2 p: hidden runs of path p, 2 p + 1: visible ones.
    std::vector<std::uint8_t> used(2 * std::size_t(paths), 0);
    const auto slot = [&](std::size_t r) { return 2 * clipped.path[runs.piece[r]] + (runs.invisibility[r] == 0); };
    for (std::size_t r = 0; r < runs.size(); ++r) used[slot(r)] = 1;
    std::vector<Index> order;
    for (Index s = 0; s < used.size(); ++s)
        if (used[s]) order.push_back(s);
    const auto value = [&](Index p) {
        return std::isnan(priority[p]) ? -std::numeric_limits<float>::infinity() : priority[p];
    };
    std::ranges::sort(order, [&](Index a, Index b) {
        const Index p = a / 2, q = b / 2;
        if ((a & 1) != (b & 1)) return (a & 1) < (b & 1);
        if (value(p) != value(q)) return value(p) < value(q);
        return id[p] != id[q] ? id[p] > id[q] : p > q;
    });
    std::vector<Index> rank(used.size(), 0);
    for (Index i = 0; i < order.size(); ++i) rank[order[i]] = i + 1;
    Array<Index> ranks(runs.size());
    for (std::size_t r = 0; r < runs.size(); ++r) ranks[r] = rank[slot(r)];
    return ranks;
}

}  // namespace fovea
