#include "atlas/runs.h"

#include <algorithm>

#include "base/check.h"
#include "base/parallel.h"
#include "path/paths.h"

namespace fovea {
namespace {

constexpr std::size_t pieces_per_block = 256;

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
            const float read = visibility[clipped.sample_start[i] + j];
            const float value = read > 0.0f ? std::min(read, 1.0f) : 0.0f;  // also what is not a number
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

/// Runs and paths of pieces ascend, so the last one tells.
void check_pieces(const ClippedPaths& clipped, const Runs& runs) {
    check(runs.piece.empty() || runs.piece.back() < clipped.path.size(), "runs: they are not of these clipped paths");
}

/// Index of the first run of each piece (pieces + 1 entries).
Array<Index> runs_of_pieces(const ClippedPaths& clipped, const Runs& runs) {
    check_pieces(clipped, runs);
    Array<Index> offsets(clipped.path.size(), 0);
    for (Index piece : runs.piece) ++offsets[piece];
    counts_to_offsets(offsets);
    return offsets;
}

/// Place in pixels at an arc length of a piece.
vec2 place(const ClippedPaths& clipped, Index piece, double arc) {
    const auto begin = clipped.arc_px.begin() + clipped.pieces.begin(piece), end = clipped.arc_px.begin() + clipped.pieces.end(piece);
    const auto above = std::clamp(std::upper_bound(begin, end, arc), begin + 1, end - 1);
    const auto i = static_cast<Index>(above - clipped.arc_px.begin());
    const double length = clipped.arc_px[i] - clipped.arc_px[i - 1];
    const double t = length > 0.0 ? std::clamp((arc - clipped.arc_px[i - 1]) / length, 0.0, 1.0) : 0.0;
    return glm::mix(clipped.px[i - 1], clipped.px[i], static_cast<float>(t));
}

/// Where a run of a contour that ends at `end` should end instead, looking back over at most fold_px along `way` (+1
/// or -1): before a fold, from which the rest runs backwards.
double trim_end(const ClippedPaths& clipped, Index piece, double start, double end, int way, double fold_px) {
    constexpr double before_px = 4.0, least_px = 1.0, cosine = -0.87;  // back within 30 degrees of the way it came
    double result = end;
    const vec2 tip = place(clipped, piece, end);
    const auto arcs = clipped.arc_px.begin();
    const double low = way > 0 ? end - fold_px : end, high = way > 0 ? end : end + fold_px;
    const auto first = std::lower_bound(arcs + clipped.pieces.begin(piece), arcs + clipped.pieces.end(piece), low) - arcs;
    for (auto i = static_cast<Index>(first); i < clipped.pieces.end(piece) && clipped.arc_px[i] <= high; ++i) {
        const double arc = clipped.arc_px[i], left = (end - arc) * way;
        if (left <= 0.0 || left > fold_px || (arc - start) * way <= before_px || left <= (end - result) * way) continue;
        const vec2 onward = clipped.px[i] - place(clipped, piece, arc - way * before_px), rest = tip - clipped.px[i];
        const double lengths = glm::length(onward) * glm::length(rest);
        if (glm::length(rest) > least_px && glm::dot(onward, rest) < cosine * lengths) result = arc;
    }
    return result;
}

/// Where a run should end so that it meets the next one, which starts at `next` beside it: the nearest place within
/// fold_px of its end, if it is near enough for one line to go on as the other.
double meet_next(const ClippedPaths& clipped, Index piece, double start, double end, double next, double fold_px) {
    constexpr double near_px = 3.0, step_px = 0.5;
    const vec2 goal = place(clipped, piece, next);
    double nearest = near_px, result = end;
    for (double arc = end; arc > std::max(start, end - fold_px); arc -= step_px) {
        const double distance = glm::length(place(clipped, piece, arc) - goal);
        if (distance < nearest) {
            nearest = distance;
            result = arc;
        }
    }
    return result;
}

}  // namespace

void Runs::push(Index of, double start, double end, std::uint8_t hidden_by) {
    if (end <= start) return;
    piece.push_back(of);
    start_px.push_back(start);
    end_px.push_back(end);
    invisibility.push_back(hidden_by);
}

void Runs::append(const Runs& more) {
    piece.insert(piece.end(), more.piece.begin(), more.piece.end());
    start_px.insert(start_px.end(), more.start_px.begin(), more.start_px.end());
    end_px.insert(end_px.end(), more.end_px.begin(), more.end_px.end());
    invisibility.insert(invisibility.end(), more.invisibility.begin(), more.invisibility.end());
}

Runs runs_from_samples(const ClippedPaths& clipped, In<float> visibility, float threshold) {
    check(visibility.size() == clipped.samples, "visibility: one value per atlas sample expected");
    const std::size_t pieces = clipped.path.size();
    std::vector<Runs> parts((pieces + pieces_per_block - 1) / pieces_per_block);
    parallel_blocks(pieces, pieces_per_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
        for (std::size_t q = begin; q < end; ++q) find_runs(clipped, visibility, threshold, static_cast<Index>(q), parts[b]);
    });
    Runs runs;
    for (const Runs& part : parts) runs.append(part);
    return runs;
}

Array<float> samples_from_runs(const ClippedPaths& clipped, const Runs& runs) {
    Array<float> samples(clipped.samples, 0.0f);
    const Array<Index> offsets = runs_of_pieces(clipped, runs);
    parallel_blocks(clipped.path.size(), pieces_per_block, [&](std::size_t, std::size_t first, std::size_t end_piece) {
        for (std::size_t q = first; q < end_piece; ++q) {
            Index run = offsets[q];
            const Index begin = clipped.pieces.begin(q), last = clipped.pieces.end(q) - 1;
            for (Index i = begin; i < last; ++i) {
                const Index count = clipped.sample_count[i];
                if (count == 0) continue;
                const double step = (clipped.arc_px[i + 1] - clipped.arc_px[i]) / count;
                for (Index j = 0; j < count; ++j) {
                    const double from = clipped.arc_px[i] + j * step, to = from + step;
                    while (run < offsets[q + 1] && runs.end_px[run] <= from) ++run;
                    double covered = 0.0;
                    for (Index r = run; r < offsets[q + 1] && runs.start_px[r] < to; ++r)
                        if (runs.invisibility[r] == 0) covered += std::min(to, runs.end_px[r]) - std::max(from, runs.start_px[r]);
                    samples[clipped.sample_start[i] + j] = static_cast<float>(std::clamp(covered / step, 0.0, 1.0));
                }
            }
        }
    });
    return samples;
}

Runs with_hidden(const ClippedPaths& clipped, const Runs& visible, In<std::uint8_t> always_seen) {
    const Array<Index> offsets = runs_of_pieces(clipped, visible);
    check(clipped.path.empty() || clipped.path.back() < always_seen.size(), "always_seen: one value per path expected");
    Runs all;
    for (Index q = 0; q < clipped.path.size(); ++q) {
        const Index begin = clipped.pieces.begin(q), last = clipped.pieces.end(q) - 1;
        const bool has_hidden = !always_seen[clipped.path[q]];
        double from = clipped.arc_px[begin];
        for (Index r = offsets[q]; r < offsets[q + 1]; ++r) {
            if (has_hidden) all.push(q, from, visible.start_px[r], 1);
            all.push(q, visible.start_px[r], visible.end_px[r]);
            from = visible.end_px[r];
        }
        if (has_hidden) all.push(q, from, clipped.arc_px[last], 1);
    }
    return all;
}

Runs close_gaps(const ClippedPaths& clipped, const Runs& runs, double gap_px, In<float> spur_px) {
    check_pieces(clipped, runs);
    for (Index path : clipped.path) check(path < spur_px.size(), "spur_px: one value per path expected");
    Runs joined;
    for (std::size_t r = 0; r < runs.piece.size(); ++r) {
        const bool same = !joined.piece.empty() && joined.piece.back() == runs.piece[r];
        if (same && runs.start_px[r] - joined.end_px.back() < gap_px) {
            joined.end_px.back() = runs.end_px[r];
        } else {
            joined.push(runs.piece[r], runs.start_px[r], runs.end_px[r]);
        }
    }
    Runs kept;
    for (std::size_t r = 0; r < joined.piece.size(); ++r) {
        const Index piece = joined.piece[r];
        const double first = clipped.arc_px[clipped.pieces.begin(piece)], last = clipped.arc_px[clipped.pieces.end(piece) - 1];
        const bool at_end = joined.start_px[r] <= first + 1e-6 || joined.end_px[r] >= last - 1e-6;
        if (at_end || joined.end_px[r] - joined.start_px[r] >= spur_px[clipped.path[piece]])
            kept.push(piece, joined.start_px[r], joined.end_px[r]);
    }
    return kept;
}

Runs trim_folds(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> of_view, double fold_px) {
    check_pieces(clipped, runs);
    check(clipped.path.empty() || clipped.path.back() < of_view.size(), "of_view: one value per path expected");
    Runs trimmed = runs;
    const std::size_t count = runs.piece.size();
    parallel_for(count, [&](std::size_t r) {
        const Index piece = runs.piece[r];
        if (!of_view[clipped.path[piece]]) return;
        const double first = clipped.arc_px[clipped.pieces.begin(piece)], last = clipped.arc_px[clipped.pieces.end(piece) - 1];
        double start = runs.start_px[r], end = runs.end_px[r];
        const bool cusps = of_view[clipped.path[piece]] == ends_at_cusps && !clipped.closed[piece];
        if (cusps || end < last - 1e-6) end = trim_end(clipped, piece, start, end, 1, fold_px);
        if (cusps || start > first + 1e-6) start = trim_end(clipped, piece, end, start, -1, fold_px);
        const bool goes_on = r + 1 < count && runs.piece[r + 1] == piece && runs.start_px[r + 1] - end < fold_px;
        if (goes_on) end = meet_next(clipped, piece, start, end, runs.start_px[r + 1], fold_px);
        trimmed.start_px[r] = start;
        trimmed.end_px[r] = end;
    });
    return trimmed;
}

}  // namespace fovea
