// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/ends_by_cell.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>

namespace fovea::runs {
namespace {

constexpr double look_back_px = 4.0;  // segments on dense meshes zigzag
constexpr std::ptrdiff_t crowd = 256;
constexpr double crowd_px = 0.5, crowd_turn = 0.125;  // roundings of places and of unit vectors

using Ends = Array<End>::iterator;

auto order(const End& e) { return std::tuple(e.row, e.placement, e.column, e.px.x, e.px.y, e.way.x, e.way.y, e.path); }

/// Sorts ends; removes those that are where an earlier one is, but for two of different paths.
Ends sorted_without_repeated(Ends begin, Ends end) {
    parallel_sort(begin, end, [](const End& a, const End& b) { return order(a) < order(b); });
    Ends kept = begin;
    int alike = 0;
    for (Ends e = begin; e != end; ++e) {
        const bool again =
            kept != begin && kept[-1].cell() == e->cell() && kept[-1].px == e->px && kept[-1].way == e->way;
        if (again && (alike == 2 || kept[-1].path == e->path)) continue;
        alike = again ? alike + 1 : 1;
        *kept++ = *e;
    }
    return kept;
}

}  // namespace

End end_of(const ClippedPaths& clipped, const Runs& runs, In<Index> placement, double cell_px, Index run, bool at_end) {
    const double start = runs.start_px[run], end = runs.end_px[run], length = std::min(look_back_px, end - start);
    const Index piece = runs.piece[run], path = clipped.path[piece];
    const dvec2 px(clipped.place_px(piece, at_end ? end : start));
    const dvec2 out = px - dvec2(clipped.place_px(piece, at_end ? end - length : start + length));
    const dvec2 cell = glm::floor(px / cell_px);
    return {std::int64_t(cell.y), std::int64_t(cell.x), placement[path], path, px, out / glm::length(out)};
}

Array<End> ends_by_cell(const ClippedPaths& clipped, const Runs& runs, In<Index> placement, double cell_px) {
    Array<End> ends;
    for (Index r = 0; r < runs.size(); ++r)
        for (const bool at_end : {false, true}) {
            if (runs.invisibility[r] != 0) continue;
            const End end = end_of(clipped, runs, placement, cell_px, r, at_end);
            if (std::isfinite(end.way.x + end.way.y)) ends.push_back(end);
        }
    ends.erase(sorted_without_repeated(ends.begin(), ends.end()), ends.end());
    Ends kept = ends.begin();
    for (Ends begin = ends.begin(); begin != ends.end();) {
        const Ends end = std::find_if(begin, ends.end(), [&](const End& e) { return e.cell() != begin->cell(); });
        Ends last = end;
        if (end - begin > crowd) {
            for (Ends e = begin; e != end; ++e) {
                e->px = glm::round(e->px / crowd_px) * crowd_px;
                e->way = glm::round(e->way / crowd_turn) * crowd_turn;
            }
            last = sorted_without_repeated(begin, end);
        }
        kept = std::move(begin, last, kept);
        begin = end;
    }
    ends.erase(kept, ends.end());
    return ends;
}

}  // namespace fovea::runs
