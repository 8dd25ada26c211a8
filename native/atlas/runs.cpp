#include "atlas/runs.h"

#include <algorithm>

#include "base/check.h"
#include "base/parallel.h"

namespace fovea {
namespace {

constexpr std::size_t pieces_per_block = 256;

void push(Runs& runs, Index piece, double start, double end) {
    if (end <= start) return;
    runs.piece.push_back(piece);
    runs.start_px.push_back(start);
    runs.end_px.push_back(end);
}

Runs join(const std::vector<Runs>& parts) {
    Runs all;
    for (const Runs& part : parts) {
        all.piece.insert(all.piece.end(), part.piece.begin(), part.piece.end());
        all.start_px.insert(all.start_px.end(), part.start_px.begin(), part.start_px.end());
        all.end_px.insert(all.end_px.end(), part.end_px.begin(), part.end_px.end());
    }
    return all;
}

/// Runs of one piece: where the line through the samples crosses the threshold.
void find_runs(const ClippedPaths& clipped, In<float> visibility, float threshold, Index piece, Runs& runs) {
    const Index begin = clipped.pieces.begin(piece), last = clipped.pieces.end(piece) - 1;
    double start = 0.0, before = clipped.arc_px[begin];
    float value_before = 0.0f;
    bool open = false, first = true;
    for (Index i = begin; i < last; ++i) {
        const double step = clipped.sample_count[i] ? (clipped.arc_px[i + 1] - clipped.arc_px[i]) / clipped.sample_count[i] : 0.0;
        for (Index j = 0; j < clipped.sample_count[i]; ++j) {
            const double here = clipped.arc_px[i] + (j + 0.5) * step;
            const float value = visibility[clipped.sample_start[i] + j];
            const bool visible = value >= threshold;
            if (visible != open) {
                const double t = first ? 0.0 : (threshold - value_before) / (value - value_before);
                const double change = before + t * (here - before);
                if (open) push(runs, piece, start, change);
                start = change;
                open = visible;
            }
            before = here;
            value_before = value;
            first = false;
        }
    }
    if (open) push(runs, piece, start, clipped.arc_px[last]);
}

/// Index of the first run of each piece (pieces + 1 entries).
Array<Index> runs_of_pieces(const ClippedPaths& clipped, const Runs& runs) {
    Array<Index> offsets(clipped.path.size(), 0);
    for (Index piece : runs.piece) ++offsets[piece];
    counts_to_offsets(offsets);
    return offsets;
}

}  // namespace

Runs runs_from_samples(const ClippedPaths& clipped, In<float> visibility, float threshold) {
    check(visibility.size() == clipped.samples, "visibility: one value per atlas sample expected");
    const std::size_t pieces = clipped.path.size();
    std::vector<Runs> parts((pieces + pieces_per_block - 1) / pieces_per_block);
    parallel_blocks(pieces, pieces_per_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
        for (std::size_t q = begin; q < end; ++q) find_runs(clipped, visibility, threshold, static_cast<Index>(q), parts[b]);
    });
    return join(parts);
}

Array<float> samples_from_runs(const ClippedPaths& clipped, const Runs& runs) {
    Array<float> samples(clipped.samples, 0.0f);
    const Array<Index> offsets = runs_of_pieces(clipped, runs);
    parallel_blocks(clipped.path.size(), pieces_per_block, [&](std::size_t, std::size_t first, std::size_t end_piece) {
        for (std::size_t q = first; q < end_piece; ++q) {
            Index run = offsets[q];
            const Index begin = clipped.pieces.begin(q), last = clipped.pieces.end(q) - 1;
            Index low = none, high = 0;
            for (Index i = begin; i < last; ++i) {
                const Index count = clipped.sample_count[i];
                if (count == 0) continue;
                low = std::min(low, clipped.sample_start[i]);
                high = clipped.sample_start[i] + count - 1;
                const double step = (clipped.arc_px[i + 1] - clipped.arc_px[i]) / count;
                for (Index j = 0; j < count; ++j) {
                    const double from = clipped.arc_px[i] + j * step, to = from + step;
                    while (run < offsets[q + 1] && runs.end_px[run] <= from) ++run;
                    double covered = 0.0;
                    for (Index r = run; r < offsets[q + 1] && runs.start_px[r] < to; ++r)
                        covered += std::min(to, runs.end_px[r]) - std::max(from, runs.start_px[r]);
                    samples[clipped.sample_start[i] + j] = static_cast<float>(std::clamp(covered / step, 0.0, 1.0));
                }
            }
            // Padding: whatever lies between this piece's samples and its neighbours' belongs to its ends.
            if (low == none) continue;
            const Index padding = padding_of(high - low + 1);
            std::fill_n(samples.begin() + low - padding, padding, samples[low]);
            std::fill_n(samples.begin() + high + 1, padding, samples[high]);
        }
    });
    return samples;
}

Runs close_gaps(const ClippedPaths& clipped, const Runs& runs, double gap_px, double spur_px) {
    Runs joined;
    for (std::size_t r = 0; r < runs.piece.size(); ++r) {
        const bool same = !joined.piece.empty() && joined.piece.back() == runs.piece[r];
        if (same && runs.start_px[r] - joined.end_px.back() < gap_px) {
            joined.end_px.back() = runs.end_px[r];
        } else {
            push(joined, runs.piece[r], runs.start_px[r], runs.end_px[r]);
        }
    }
    Runs kept;
    for (std::size_t r = 0; r < joined.piece.size(); ++r) {
        const Index piece = joined.piece[r];
        const double first = clipped.arc_px[clipped.pieces.begin(piece)], last = clipped.arc_px[clipped.pieces.end(piece) - 1];
        const bool at_end = joined.start_px[r] <= first + 1e-6 || joined.end_px[r] >= last - 1e-6;
        if (at_end || joined.end_px[r] - joined.start_px[r] >= spur_px)
            push(kept, piece, joined.start_px[r], joined.end_px[r]);
    }
    return kept;
}

}  // namespace fovea
