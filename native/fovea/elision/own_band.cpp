// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/own_band.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::elision {
namespace {

constexpr std::size_t pieces_per_block = 256;
constexpr float least_half_width_px = 0.5f, most_half_width_px = 4096.0f;

/// The run that owns a stretch of a piece.
struct Cover {
    Index run = none;
    double share = 0.0;  // of the stretch covered by runs of its class (visible or hidden)
};

Cover cover(const Runs& runs, Index first, Index last, double from, double to) {
    double longest = 0.0, of_class[2] = {0.0, 0.0};
    Cover found;
    for (Index r = first; r < last && runs.start_px[r] < to; ++r) {
        const double length = std::min(to, runs.end_px[r]) - std::max(from, runs.start_px[r]);
        if (length <= 0.0) continue;
        of_class[runs.invisibility[r] == 0] += length;
        if (length > longest) {
            longest = length;
            found.run = r;
        }
    }
    if (found.run != none) found.share = std::min(1.0, of_class[runs.invisibility[found.run] == 0] / (to - from));
    return found;
}

/// Collects the samples of some pieces.
class Samples {
   public:
    Samples(const ClippedPaths& clipped, const Runs& runs, In<Index> ranks, In<float> half_width_px, OwnBands& own)
        : clipped_(clipped), runs_(runs), ranks_(ranks), half_width_px_(half_width_px), own_(own) {}

    /// Adds the samples of a piece. `counts`: samples of each run.
    void add(Index piece, Index run, Index last_run, Array<Index>& counts) {
        counted_ = none;
        for (Index i = clipped_.pieces.begin(piece); i + 1 < clipped_.pieces.end(piece); ++i) {
            const Index count = clipped_.sample_count[i];
            const double begin = clipped_.arc_px[i],
                         step = (clipped_.arc_px[i + 1] - begin) / std::max(count, Index(1));
            while (run < last_run && runs_.end_px[run] <= begin) ++run;
            if (run == last_run) return;
            if (runs_.start_px[run] >= clipped_.arc_px[i + 1]) continue;
            for (Index j = 0; j < count; ++j) {
                const double from = begin + j * step;
                while (run < last_run && runs_.end_px[run] <= from) ++run;
                const Cover here = cover(runs_, run, last_run, from, from + step);
                if (here.run == none) continue;
                ++counts[here.run];
                if (here.run != counted_) find_ends(piece, here.run);
                add_sample(i, j, from + 0.5 * step, here);
            }
        }
    }

   private:
    void find_ends(Index piece, Index run) {
        counted_ = run;
        ends_ = {clipped_.place_px(piece, runs_.start_px[run]), clipped_.place_px(piece, runs_.end_px[run])};
    }

    void add_sample(Index i, Index j, double middle, const Cover& here) {
        const vec2 start = clipped_.px[i], way = clipped_.px[i + 1] - start;
        const float length = glm::length(way);
        const vec2 along = length > 0.0f ? way / length : vec2(1.0f, 0.0f);
        const Index s = clipped_.sample_start[i] + j;
        const float wanted = half_width_px_[s] > 0.0f ? std::min(half_width_px_[s], most_half_width_px) : 0.0f;
        own_.sample.push_back(s);
        own_.place.push_back({start + way * ((float(j) + 0.5f) / float(clipped_.sample_count[i])), along});
        own_.band.push_back({std::max(least_half_width_px, wanted * float(here.share)), float(ranks_[here.run]),
                             float(middle - runs_.start_px[here.run]), float(runs_.end_px[here.run] - middle)});
        own_.ends.push_back(ends_);
        own_.figure.push_back({-1.0f, 0.0f, float(runs_.end_px[here.run] - runs_.start_px[here.run])});
    }

    const ClippedPaths& clipped_;
    const Runs& runs_;
    In<Index> ranks_;
    In<float> half_width_px_;
    OwnBands& own_;
    Index counted_ = none;
    vec4 ends_{0.0f};
};

}  // namespace

OwnBands own_bands(const ClippedPaths& clipped, const Runs& runs, In<Index> ranks, In<float> half_width_px,
                   float reach_px) {
    check(reach_px > 0.0f, "elision: the reach of ends must be positive");
    check(half_width_px.size() == clipped.samples, "elision: one half width per atlas sample expected");
    check(ranks.size() == runs.size(), "elision: one rank per run expected");
    const Rows rows = runs_of_pieces(clipped, runs);
    Array<Index> counts(runs.size(), 0);
    const auto parts = parallel_parts<OwnBands>(clipped.path.size(), pieces_per_block,
                                                [&](OwnBands& part, std::size_t first, std::size_t last) {
                                                    Samples samples(clipped, runs, ranks, half_width_px, part);
                                                    for (Index q = Index(first); q < last; ++q)
                                                        if (rows.size(q) > 0)
                                                            samples.add(q, rows.begin(q), rows.end(q), counts);
                                                });
    counts_to_offsets(counts);
    OwnBands own;
    resize_columns(own, OwnBands::columns, counts.back());
    own.runs.offsets = std::move(counts);
    std::vector<std::size_t> bases;
    for (const OwnBands& part : parts) bases.push_back(part.sample.size());
    counts_to_offsets(bases);
    parallel_for(parts.size(), 1, [&](std::size_t b) { copy_columns(parts[b], OwnBands::columns, own, bases[b]); });
    own.reach_px = reach_px;
    return own;
}

}  // namespace fovea::elision
