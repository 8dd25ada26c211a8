// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/compaction.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/visibility/segment.h>

namespace fovea::runs {
namespace {

constexpr double whole_error = 1e-3;  // px: tolerance for a run that covers a whole closed piece
constexpr double look_back = 3.0;     // px; the last segments on a dense mesh have no reliable direction

/// Points of the piece within a run: first .. last.
struct Inner {
    Index first, last;
};

Inner inner_points(const ClippedPaths& clipped, Index piece, double start, double end) {
    const auto arcs = clipped.arc_px.begin();
    const auto last = arcs + clipped.pieces.end(piece);
    const auto from = std::upper_bound(arcs + clipped.pieces.begin(piece), last, start);
    const auto to = std::lower_bound(from, last, end);
    return {static_cast<Index>(from - arcs), static_cast<Index>(to - arcs)};
}

/// Writes the points of runs.
class Writer {
   public:
    Writer(const ClippedPaths& clipped, const Paths& paths, CompactRuns& out)
        : clipped_(clipped), paths_(paths), out_(out) {}

    void write(std::size_t run) {
        piece_ = out_.piece[run];
        begin_ = clipped_.pieces.begin(piece_);
        last_ = clipped_.pieces.end(piece_) - 1;
        const double start = out_.start_px[run], end = out_.end_px[run];
        const Inner inner = inner_points(clipped_, piece_, start, end);
        Index at = out_.rows.begin(static_cast<Index>(run));
        write_end(at++, start);
        for (Index i = inner.first; i < inner.last; ++i) write_point(at++, i);
        write_end(at, end);
        out_.kinds[at] = out_.kinds[at - 1];
    }

   private:
    float strength(Index point) const { return clipped_.at_point(paths_.strength, point); }

    void write_point(Index at, Index point) {
        out_.px[at] = clipped_.px[point];
        out_.position_view[at] = clipped_.position_view[point];
        out_.arc_px[at] = clipped_.arc_px[point];
        out_.strength[at] = strength(point);
        out_.kinds[at] = paths_.kinds[clipped_.source[std::min(point, last_ - 1)]];
    }

    void write_end(Index at, double arc) {
        if (arc < clipped_.arc_px[begin_]) {
            write_beyond(at, begin_, 1, arc);
        } else if (arc > clipped_.arc_px[last_]) {
            write_beyond(at, last_, -1, arc);
        } else {
            write_between(at, arc);
        }
    }

    void write_between(Index at, double arc) {
        const Index before = clipped_.segment_at(piece_, arc), after = before + 1;
        const double s = clipped_.share_at(before, arc);
        const dvec3 a(clipped_.position_view[before]), b(clipped_.position_view[after]);
        // Screen fraction of the segment, and the same position as its fraction in space. No difference of depths,
        // which vanishes where one is a million times the other.
        const double t = clipped_.orthographic ? s : s * a.z / ((1.0 - s) * b.z + s * a.z);
        out_.px[at] = vec2(glm::mix(dvec2(clipped_.px[before]), dvec2(clipped_.px[after]), s));
        out_.position_view[at] = vec3(glm::mix(a, b, t));
        out_.arc_px[at] = arc;
        out_.strength[at] = glm::mix(strength(before), strength(after), static_cast<float>(t));
        out_.kinds[at] = paths_.kinds[clipped_.source[before]];
    }

    /// Writes a point straight beyond an end of the piece; `inwards` (1 or -1): index step from that end to inner
    /// points.
    void write_beyond(Index at, Index end, int inwards, double arc) {
        write_point(at, end);
        out_.arc_px[at] = arc;
        const Index other_end = inwards > 0 ? last_ : begin_;
        Index inner = end;
        while (inner != other_end && glm::distance(clipped_.px[inner], clipped_.px[end]) <= look_back) inner += inwards;
        const dvec2 way = dvec2(clipped_.px[end]) - dvec2(clipped_.px[inner]);
        if (!(glm::length(way) > 0.0)) return;
        const double lengths = std::abs(arc - clipped_.arc_px[end]) / glm::length(way);
        const dvec3 a(clipped_.position_view[inner]), b(clipped_.position_view[end]);
        const dvec2 direction = clipped_.orthographic ? dvec2(b - a) : dvec2(b) - dvec2(a) * (b.z / a.z);
        out_.px[at] = vec2(dvec2(clipped_.px[end]) + way * lengths);
        out_.position_view[at] = vec3(b + dvec3(direction * lengths, 0.0));
    }

    const ClippedPaths& clipped_;
    const Paths& paths_;
    CompactRuns& out_;
    Index piece_ = 0, begin_ = 0, last_ = 0;  // the current piece, and its first and last point
};

}  // namespace

CompactRuns compact(const ClippedPaths& clipped, const Paths& paths, const Runs& runs) {
    check_runs(clipped, runs);
    const std::size_t count = runs.size();
    check_same_paths(clipped, paths, "compact");
    CompactRuns out;
    resize_columns(out, CompactRuns::run_columns, count);
    out.rows.offsets.resize(count);
    out.piece = runs.piece;
    out.start_px = runs.start_px;
    out.end_px = runs.end_px;
    out.invisibility = runs.invisibility;
    parallel_for(count, [&](std::size_t r) {
        const Index piece = runs.piece[r], path = clipped.path[piece];
        const Inner inner = inner_points(clipped, piece, runs.start_px[r], runs.end_px[r]);
        out.rows.offsets[r] = 2 + inner.last - inner.first;
        out.path[r] = path;
        out.path_id[r] = paths.id[path];
        out.line_set[r] = paths.line_set[path];
        out.closed[r] = clipped.closed[piece] && runs.start_px[r] < clipped.first_arc(piece) + whole_error &&
                        runs.end_px[r] > clipped.last_arc(piece) - whole_error;
    });
    std::uint64_t points = 0;
    for (Index size : out.rows.offsets) points += size;
    check(points < none, "compact: more than four billion points");
    counts_to_offsets(out.rows.offsets);
    resize_columns(out, CompactRuns::point_columns, points);
    parallel_blocks(count, 1024, [&](std::size_t, std::size_t first, std::size_t last) {
        Writer writer(clipped, paths, out);
        for (std::size_t r = first; r < last; ++r) writer.write(r);
    });
    return out;
}

}  // namespace fovea::runs
