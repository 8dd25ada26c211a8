// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/groups.h>

#include <algorithm>
#include <bit>
#include <tuple>

#include <fovea/base/check.h>
#include <fovea/base/disjoint_sets.h>
#include <fovea/runs/chain.h>

namespace fovea::runs {
namespace {

/// An end of a run, by its point in space: ends of paths at one vertex of a mesh have the same bits.
struct End {
    Index placement;
    std::uint32_t x, y, z;
    Index run;

    auto place() const { return std::tuple(placement, x, y, z); }
    auto order() const { return std::tuple(placement, x, y, z, run); }
};

/// How a run of a piece ends.
struct RunEnds {
    RunEnds(const ClippedPaths& clipped, const Runs& runs, std::size_t run) {
        const Index piece = runs.piece[run];
        const bool first = runs.start_px[run] <= clipped.first_arc(piece) + same_place_px;
        const bool last = runs.end_px[run] >= clipped.last_arc(piece) - same_place_px;
        hidden = !first || !last;
        at_start = first && (clipped.ends[piece] & path_start);
        at_end = last && (clipped.ends[piece] & path_end);
    }
    bool at_start, at_end, hidden;
};

bool belongs(const ClippedPaths& clipped, const Runs& runs, In<Index> placement, std::size_t run) {
    return runs.invisibility[run] == 0 && placement[clipped.path[runs.piece[run]]] != none;
}

/// Ends of runs that are ends of their paths, sorted by place.
Array<End> ends_of_paths(const ClippedPaths& clipped, const Runs& runs, In<Index> placement) {
    Array<End> all;
    const auto add = [&](std::size_t run, Index point) {
        const vec3& p = clipped.position_view[point];
        all.push_back({placement[clipped.path[runs.piece[run]]], std::bit_cast<std::uint32_t>(p.x),
                       std::bit_cast<std::uint32_t>(p.y), std::bit_cast<std::uint32_t>(p.z), Index(run)});
    };
    for (std::size_t r = 0; r < runs.size(); ++r) {
        if (!belongs(clipped, runs, placement, r)) continue;
        const RunEnds ends(clipped, runs, r);
        if (ends.at_start) add(r, clipped.pieces.begin(runs.piece[r]));
        if (ends.at_end) add(r, clipped.pieces.end(runs.piece[r]) - 1);
    }
    parallel_sort(all.begin(), all.end(), [](const End& a, const End& b) { return a.order() < b.order(); });
    return all;
}

/// Box around a part of a piece.
struct Box {
    vec2 low{1e30f}, high{-1e30f};

    void hold(const vec2& px) {
        low = glm::min(low, px);
        high = glm::max(high, px);
    }
    void hold(const ClippedPaths& clipped, Index piece, double start, double end) {
        hold(clipped.place_px(piece, start));
        hold(clipped.place_px(piece, end));
        Index i = clipped.segment_at(piece, start) + 1;
        for (; i < clipped.pieces.end(piece) && clipped.arc_px[i] < end; ++i) hold(clipped.px[i]);
    }
    float size() const { return std::max(high.x - low.x, high.y - low.y); }
};

}  // namespace

Groups group_runs(const ClippedPaths& clipped, const Runs& runs, In<Index> placement, bool whole_paths) {
    check_runs(clipped, runs);
    check(clipped.path.empty() || clipped.path.back() < placement.size(), "groups: one placement per path expected");
    DisjointSets sets(runs.size());
    const Array<End> ends = ends_of_paths(clipped, runs, placement);
    for (std::size_t k = 1; k < ends.size(); ++k)
        if (ends[k].place() == ends[k - 1].place()) sets.join(ends[k].run, ends[k - 1].run);
    Index last = none;  // visible run
    for (Index r = 0; whole_paths && r < runs.size(); ++r) {
        if (!belongs(clipped, runs, placement, r)) continue;
        if (last != none && clipped.path[runs.piece[last]] == clipped.path[runs.piece[r]]) sets.join(last, r);
        last = r;
    }
    Groups groups;
    groups.of_run.assign(runs.size(), none);
    Array<Box> boxes;
    for (Index r = 0; r < runs.size(); ++r) {
        if (!belongs(clipped, runs, placement, r)) continue;
        const Index root = sets.name(r);
        if (root == r) {
            groups.of_run[r] = Index(boxes.size());
            boxes.emplace_back();
            groups.length_px.push_back(0.0f);
            groups.hidden.push_back(0);
        }
        const Index group = groups.of_run[r] = groups.of_run[root];
        boxes[group].hold(clipped, runs.piece[r], runs.start_px[r], runs.end_px[r]);
        groups.length_px[group] += float(runs.end_px[r] - runs.start_px[r]);
        groups.hidden[group] |= RunEnds(clipped, runs, r).hidden;
    }
    groups.size_px = parallel_map<float>(boxes.size(), [&](std::size_t g) { return boxes[g].size(); });
    return groups;
}

}  // namespace fovea::runs
