// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/seen_lines.h>

#include <algorithm>
#include <utility>

#include <fovea/elision/found_places.h>
#include <fovea/project/piece_arcs.h>

namespace fovea::elision {
namespace {

using Stretch = SeenLines::Stretch;

struct OnPath {
    Index path;
    Stretch stretch;
};

/// Appends the stretches of a piece, whose runs are first .. last - 1.
void add_stretches(const ClippedPaths& clipped, const Paths& paths, const Runs& runs, Index piece, Index first,
                   Index last, Array<OnPath>& out) {
    const project::PieceArcs arcs(clipped, paths, piece);
    const double end = clipped.last_arc(piece);
    double at = arcs.in_space(clipped.first_arc(piece));
    const auto go_to = [&](double px, bool seen) {
        const double to = arcs.in_space(px);
        if (at < to) out.push_back({clipped.path[piece], {at, to, seen}});
        at = std::max(at, to);
    };
    for (Index r = first; r < last; ++r) {
        if (runs.invisibility[r] != 0) continue;
        go_to(runs.start_px[r], false);
        go_to(runs.end_px[r], true);
    }
    go_to(end, false);
}

}  // namespace

std::optional<bool> is_seen(In<Stretch> stretches, double arc) {
    const auto stretch = std::ranges::lower_bound(stretches, arc, {}, &Stretch::to);
    return stretch != stretches.end() && stretch->from <= arc ? std::optional(stretch->seen) : std::nullopt;
}

SeenLines seen_lines(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const Runs& runs,
                     std::shared_ptr<const ViewLines> of_view) {
    const Rows rows = runs_of_pieces(clipped, runs);
    const auto found =
        parallel_collect<OnPath>(clipped.path.size(), 256, [&](std::size_t begin, std::size_t end, auto& out) {
            for (Index q = Index(begin); q < end; ++q)
                if (clipped.pieces.size(q) > 1 && (!paths.of_view[clipped.path[q]] || of_view->rows.size(q) > 0))
                    add_stretches(clipped, paths, runs, q, rows.begin(q), rows.end(q), out);
        });
    SeenLines lines;
    lines.stretches = lists_of<Stretch>(paths.count(), [&](const auto& give) {
        for (const OnPath& each : found) give(each.path, each.stretch);
    });
    Array<Index> some, of_mesh;
    for (Index p = 0; p < paths.count(); ++p) {
        if (lines.stretches.size(p) == 0) continue;
        some.push_back(p);
        if (!paths.of_view[p]) of_mesh.push_back(p);
    }
    parallel_for(some.size(), 256,
                 [&](std::size_t k) { std::ranges::sort(lines.stretches[some[k]], {}, &Stretch::from); });
    lines.parts = LineParts(paths, scene, of_mesh).sorted;
    lines.seen = parallel_map<std::uint8_t>(of_view->places.size(), [&](std::size_t j) {
        const ViewLines::Place& place = of_view->places[j];
        return is_seen(std::as_const(lines.stretches)[of_view->path[place.piece]], place.arc_space).value_or(false);
    });
    lines.beside = are_beside(*of_view, lines.seen);
    lines.of_view = std::move(of_view);
    return lines;
}

}  // namespace fovea::elision
