// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/polylines.h>

#include <algorithm>

namespace fovea::draw {
namespace {

/// A sample of a piece: its arc length [px], and its atlas index. Lists of them ascend by arc length.
struct PieceSample {
    double arc;
    Index number;
};

void samples_of(const ClippedPaths& clipped, Index piece, std::vector<PieceSample>& samples) {
    samples.clear();
    for (Index i = clipped.pieces.begin(piece); i + 1 < clipped.pieces.end(piece); ++i)
        for (Index j = 0; j < clipped.sample_count[i]; ++j) {
            const double share = (j + 0.5) / clipped.sample_count[i];
            samples.push_back({glm::mix(clipped.arc_px[i], clipped.arc_px[i + 1], share), clipped.sample_start[i] + j});
        }
}

float mean_between(const std::vector<PieceSample>& samples, In<float> values, double start, double end) {
    const auto at = [&](double arc) { return std::ranges::lower_bound(samples, arc, {}, &PieceSample::arc); };
    const auto first = at(start), last = at(end);
    double sum = 0.0;
    for (auto it = first; it != last; ++it) sum += values[it->number];
    if (first != last) return float(sum / double(last - first));
    const double middle = 0.5 * (start + end);
    const auto after = at(middle);
    if (after == samples.begin()) return values[after->number];
    const auto before = after - 1;
    if (after == samples.end()) return values[before->number];
    const double share = (middle - before->arc) / (after->arc - before->arc);
    return float(glm::mix(double(values[before->number]), double(values[after->number]), share));
}

}  // namespace

Array<float> means_over(const ClippedPaths& clipped, const CompactRuns& lines, In<float> values) {
    Array<float> means(lines.piece.size());
    std::vector<PieceSample> samples;
    for (std::size_t r = 0; r < means.size(); ++r) {
        if (r == 0 || lines.piece[r] != lines.piece[r - 1]) samples_of(clipped, lines.piece[r], samples);
        means[r] = samples.empty() ? 1.0f : mean_between(samples, values, lines.start_px[r], lines.end_px[r]);
    }
    return means;
}

Polylines polylines_of(Frame& frame, bool drawn) {
    drawn ? frame.shape() : frame.thin();
    const Runs& runs = drawn ? *frame.drawn : *frame.runs;
    Polylines found{compact(*frame.clipped, *frame.paths, runs), {}, {}};
    if (drawn) {
        const In<Index> pens = frame.inking(frame.shown).pen_of_run;
        found.pen.assign(pens.begin(), pens.end());
    } else {
        const Pens pens = pens_of(frame.job.style, *frame.job.assets, frame.scale());
        found.pen = pens_of_runs(*frame.clipped, runs, frame.paths->line_set, pens.ranges);
    }
    if (frame.shown.empty())
        found.shown.assign(found.path.size(), 1.0f);
    else
        found.shown = means_over(*frame.clipped, found, frame.shown);
    return found;
}

}  // namespace fovea::draw
