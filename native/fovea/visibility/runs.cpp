// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/runs.h>

#include <algorithm>

#include <fovea/base/check.h>

namespace fovea::visibility {
namespace {

/// Runs of one piece, between crossings of the threshold by the linear interpolant of the samples.
void find_runs(const ClippedPaths& clipped, In<float> visibility, float threshold, Index piece, Runs& runs) {
    const Index begin = clipped.pieces.begin(piece), last = clipped.pieces.end(piece) - 1;
    double start = 0.0, before = clipped.arc_px[begin];
    float value_before = 0.0f;
    bool open = false, first = true;
    for (Index i = begin; i < last; ++i) {
        const double step =
            clipped.sample_count[i] ? (clipped.arc_px[i + 1] - clipped.arc_px[i]) / clipped.sample_count[i] : 0.0;
        for (Index j = 0; j < clipped.sample_count[i]; ++j) {
            const double here = clipped.arc_px[i] + (j + 0.5) * step;
            const float read = visibility[clipped.sample_start[i] + j];
            const float value = read > 0.0f ? std::min(read, 1.0f) : 0.0f;  // NaN: 0
            const bool visible = value >= threshold;
            if (visible != open) {
                const double t = first ? 0.0 : (threshold - value_before) / (value - value_before);
                const double change = before + t * (here - before);
                if (open) runs.push(piece, start, change);
                start = change;
                open = visible;
            }
            before = here;
            value_before = value;
            first = false;
        }
    }
    if (open) runs.push(piece, start, clipped.arc_px[last]);
}

}  // namespace

void Runs::push(Index of, double start, double end, std::uint8_t hidden_by) {
    if (!(end - start > same_place_px)) return;
    piece.push_back(of);
    start_px.push_back(start);
    end_px.push_back(end);
    invisibility.push_back(hidden_by);
}

void Runs::append(const Runs& more) {
    const std::size_t before = size();
    resize_columns(*this, columns, before + more.size());
    copy_columns(more, columns, *this, before);
}

void check_runs(const ClippedPaths& clipped, const Runs& runs) {
    check(runs.piece.empty() || runs.piece.back() < clipped.path.size(), "runs: they are not of these clipped paths");
}

Rows runs_of_pieces(const ClippedPaths& clipped, const Runs& runs) {
    check_runs(clipped, runs);
    Array<Index> counts(clipped.path.size(), 0);
    for (Index piece : runs.piece) ++counts[piece];
    counts_to_offsets(counts);
    return {std::move(counts)};
}

Runs runs_from_samples(const ClippedPaths& clipped, In<float> visibility, float threshold) {
    check(visibility.size() == clipped.samples, "visibility: one value per atlas sample expected");
    return runs_by_blocks(clipped.path.size(), pieces_per_block, [&](Runs& runs, std::size_t begin, std::size_t end) {
        for (std::size_t q = begin; q < end; ++q) find_runs(clipped, visibility, threshold, Index(q), runs);
    });
}

Array<float> samples_from_runs(const ClippedPaths& clipped, const Runs& runs) {
    Array<float> samples(clipped.samples, 0.0f);
    const Rows rows = runs_of_pieces(clipped, runs);
    parallel_blocks(clipped.path.size(), pieces_per_block, [&](std::size_t, std::size_t first, std::size_t end_piece) {
        for (std::size_t q = first; q < end_piece; ++q) {
            Index run = rows.begin(q);
            for (Index i = clipped.pieces.begin(q); i + 1 < clipped.pieces.end(q); ++i) {
                const Index count = clipped.sample_count[i];
                const double step = (clipped.arc_px[i + 1] - clipped.arc_px[i]) / count;
                for (Index j = 0; j < count; ++j) {
                    const double from = clipped.arc_px[i] + j * step, to = from + step;
                    while (run < rows.end(q) && runs.end_px[run] <= from) ++run;
                    double covered = 0.0;
                    for (Index r = run; r < rows.end(q) && runs.start_px[r] < to; ++r)
                        if (runs.invisibility[r] == 0)
                            covered += std::min(to, runs.end_px[r]) - std::max(from, runs.start_px[r]);
                    // Far along a path, a short segment may have no length: a run covers it or not.
                    const bool within = run < rows.end(q) && runs.invisibility[run] == 0 && runs.start_px[run] <= from;
                    const double share = step > 0.0 ? std::clamp(covered / step, 0.0, 1.0) : double(within);
                    samples[clipped.sample_start[i] + j] = static_cast<float>(share);
                }
            }
        }
    });
    return samples;
}

Runs with_hidden(const ClippedPaths& clipped, const Runs& visible, In<Index> placement) {
    const Rows rows = runs_of_pieces(clipped, visible);
    check(clipped.path.empty() || clipped.path.back() < placement.size(), "placement: one value per path expected");
    Runs all;
    for (Index q = 0; q < clipped.path.size(); ++q) {
        const bool has_hidden = placement[clipped.path[q]] != none;
        double from = clipped.first_arc(q);
        for (Index r = rows.begin(q); r < rows.end(q); ++r) {
            if (has_hidden) all.push(q, from, visible.start_px[r], 1);
            all.push(visible, r);
            from = visible.end_px[r];
        }
        if (has_hidden) all.push(q, from, clipped.last_arc(q), 1);
    }
    return all;
}

}  // namespace fovea::visibility
