// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/compaction.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea {
namespace {

constexpr double whole_error = 1e-3;  // px a run may miss at the ends of a closed piece that it covers
constexpr double look_back = 3.0;     // px: at its very end a dense mesh's line leads anywhere

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
        const Index piece = out_.piece[run];
        begin_ = clipped_.pieces.begin(piece);
        last_ = clipped_.pieces.end(piece) - 1;
        const double start = out_.start_px[run], end = out_.end_px[run];
        const Inner inner = inner_points(clipped_, piece, start, end);
        Index at = out_.rows.begin(static_cast<Index>(run));
        write_end(at++, start);
        for (Index i = inner.first; i < inner.last; ++i) write_point(at++, i);
        write_end(at, end);
        out_.kinds[at] = out_.kinds[at - 1];
    }

   private:
    float strength(Index point) const {
        const Index source = clipped_.source[point];
        const float t = clipped_.source_t[point], here = paths_.strength[source];
        return t > 0.0f ? glm::mix(here, paths_.strength[source + 1], t) : here;
    }

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
        const auto arcs = clipped_.arc_px.begin();
        const Index after = static_cast<Index>(std::upper_bound(arcs + begin_ + 1, arcs + last_, arc) - arcs),
                    before = after - 1;
        const double length = arcs[after] - arcs[before];
        const double s = length > 0.0 ? std::clamp((arc - arcs[before]) / length, 0.0, 1.0) : 0.0;
        const dvec3 a(clipped_.position_view[before]), b(clipped_.position_view[after]);
        // A share of the segment in the image, and the same place as a share of it in space.
        const double t = clipped_.orthographic ? s : s * a.z / (b.z + s * (a.z - b.z));
        out_.px[at] = vec2(glm::mix(dvec2(clipped_.px[before]), dvec2(clipped_.px[after]), s));
        out_.position_view[at] = vec3(glm::mix(a, b, t));
        out_.arc_px[at] = arc;
        out_.strength[at] = glm::mix(strength(before), strength(after), static_cast<float>(t));
        out_.kinds[at] = paths_.kinds[clipped_.source[before]];
    }

    /// Straight on beyond an end of the piece, whose inner points follow in the direction `inwards`.
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
    Index begin_ = 0, last_ = 0;  // points of the piece that is being written
};

}  // namespace

CompactRuns compact(const ClippedPaths& clipped, const Paths& paths, const Runs& runs) {
    check_runs(clipped, runs);
    const std::size_t count = runs.size();
    check(
        clipped.path.empty() || (clipped.path.back() < paths.count() && clipped.source.back() < paths.strength.size()),
        "compact: these are not the paths that were clipped");
    CompactRuns out;
    out.piece = runs.piece;
    out.start_px = runs.start_px;
    out.end_px = runs.end_px;
    out.invisibility = runs.invisibility;
    const auto resize = [](std::size_t size, auto&... arrays) { (arrays.resize(size), ...); };
    resize(count, out.path_id, out.path, out.line_set, out.closed, out.rows.offsets);
    parallel_for(count, [&](std::size_t r) {
        const Index piece = runs.piece[r], path = clipped.path[piece];
        const Inner inner = inner_points(clipped, piece, runs.start_px[r], runs.end_px[r]);
        out.rows.offsets[r] = 2 + inner.last - inner.first;
        out.path[r] = path;
        out.path_id[r] = paths.id[path];
        out.line_set[r] = paths.line_set[path];
        out.closed[r] = clipped.closed[piece] &&
                        runs.start_px[r] < clipped.arc_px[clipped.pieces.begin(piece)] + whole_error &&
                        runs.end_px[r] > clipped.arc_px[clipped.pieces.end(piece) - 1] - whole_error;
    });
    std::uint64_t points = 0;
    for (Index size : out.rows.offsets) points += size;
    check(points < none, "compact: more than four billion points");
    counts_to_offsets(out.rows.offsets);
    resize(points, out.px, out.position_view, out.arc_px, out.strength, out.kinds);
    parallel_blocks(count, 1024, [&](std::size_t, std::size_t first, std::size_t last) {
        Writer writer(clipped, paths, out);
        for (std::size_t r = first; r < last; ++r) writer.write(r);
    });
    return out;
}

}  // namespace fovea
