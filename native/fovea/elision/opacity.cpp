// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/opacity.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::elision {
namespace {

constexpr std::size_t taps_aside = 4;

/// Calls body(run, begin, end) for the samples of every run.
template <typename Body>
void for_runs(const Rows& runs, const Body& body) {
    parallel_for(runs.count(), 64, [&](std::size_t r) {
        if (runs.size(Index(r)) > 0) body(r, runs.begin(Index(r)), runs.end(Index(r)));
    });
}

/// Sliding-window reduction by `better` (minimum or maximum): out[i] is that of values[i] .. values[i + length - 1],
/// for every full window.
template <typename Better>
void windows(const std::vector<float>& values, std::size_t length, std::vector<float>& out, const Better& better) {
    // Van Herk 1992: in blocks of `length`, every window is a suffix of one block and a prefix of the next.
    const std::size_t count = values.size();
    std::vector<float> ahead(count), back(count);
    for (std::size_t i = 0; i < count; ++i) ahead[i] = i % length ? better(ahead[i - 1], values[i]) : values[i];
    for (std::size_t i = count; i-- > 0;)
        back[i] = i + 1 < count && (i + 1) % length ? better(back[i + 1], values[i]) : values[i];
    out.resize(count - length + 1);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = better(back[i], ahead[i + length - 1]);
}

/// Gray-scale opening with full windows of `length` values; for fractional lengths, interpolated between the two
/// integer ones. For fewer values than that, their minimum.
class Opening {
   public:
    void operator()(float* values, std::size_t count, double length) {
        if (std::all_of(values, values + count, [&](float v) { return v == values[0]; })) return;
        const std::size_t whole = std::size_t(length);
        longer_.assign(values, values + count);
        open(longer_.data(), count, whole + 1);
        open(values, count, whole);
        const float share = float(length - double(whole));
        for (std::size_t i = 0; i < count; ++i) values[i] = glm::mix(values[i], longer_[i], share);
    }

   private:
    void open(float* values, std::size_t count, std::size_t length) {
        length = std::min(length, count);
        if (length < 2) return;
        values_.assign(values, values + count);
        windows(values_, length, least_, [](float a, float b) { return std::min(a, b); });
        values_.assign(count + length - 1, 0.0f);
        std::ranges::copy(least_, values_.begin() + (length - 1));
        windows(values_, length, most_, [](float a, float b) { return std::max(a, b); });
        std::copy_n(most_.begin(), count, values);
    }

    std::vector<float> values_, least_, most_, longer_;
};

/// Share of a band that is left, of (lost, own) pixels.
float left_of(const dvec2& sum) { return sum.y > 0.0 ? float(std::clamp(1.0 - sum.x / sum.y, 0.0, 1.0)) : 1.0f; }

/// Mixes the scores of small figures towards what is left of the whole figure.
void mix_in_figures(const OwnBands& own, In<vec2> crowding, Array<float>& scores) {
    const auto figure_at = [&](std::size_t s) { return std::size_t(own.figure[s].x); };
    std::size_t figures = 0;
    for (const float figure : own.figure_of_rank) figures = std::max(figures, std::size_t(figure + 1.0f));
    std::vector<dvec2> sums(figures, dvec2(0.0));
    for (std::size_t s = 0; s < scores.size(); ++s)
        if (own.figure[s].y > 0.0f) sums[figure_at(s)] += dvec2(crowding[s]);
    parallel_for(scores.size(), [&](std::size_t s) {
        if (own.figure[s].y > 0.0f) scores[s] = glm::mix(scores[s], left_of(sums[figure_at(s)]), own.figure[s].y);
    });
}

/// Average distance between the samples of a stretch [px].
double spacing(const OwnBands& own, std::size_t begin, std::size_t end) {
    const double px = double(own.band[end - 1].z) - own.band[begin].z;
    return px / double(std::max<std::size_t>(1, end - 1 - begin));
}

}  // namespace

Array<float> elision_scores(const OwnBands& own, In<vec2> crowding) {
    check(crowding.size() == own.sample.size(), "elision: one pair per sample of a run expected");
    Array<float> scores(crowding.size());
    for_runs(own.runs, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t s = begin; s < end; ++s) {
            vec2 sum(0.0f);
            const std::size_t first = s - std::min(taps_aside, s - begin);
            for (std::size_t t = first; t < std::min(end, s + taps_aside + 1); ++t) sum += crowding[t];
            scores[s] = left_of(dvec2(sum));
        }
    });
    mix_in_figures(own, crowding, scores);
    return scores;
}

Array<float> elision_opacities(const ClippedPaths& clipped, const OwnBands& own, In<float> scores,
                               const ElisionOptions& options) {
    check(scores.size() == own.sample.size(), "elision: one score per sample of a run expected");
    check(own.sample.empty() || own.sample.back() < clipped.samples, "elision: samples of other paths");
    check(options.fade_from >= 0.0f && options.fade_from < 1.0f, "elision: fade_from must be in [0, 1)");
    check(options.stub_px >= 0.0, "elision: stub_px must be 0 or more");
    Array<float> opacities(clipped.samples), left(scores.size());
    parallel_blocks(opacities.size(), 1 << 16, [&](auto, std::size_t begin, std::size_t end) {
        std::fill_n(opacities.begin() + begin, end - begin, 1.0f);
    });
    for_runs(own.runs, [&](std::size_t r, std::size_t begin, std::size_t end) {
        const float dot = own.dot.empty() ? 0.0f : own.dot[r];
        static thread_local Opening open;
        for (std::size_t s = begin; s < end; ++s) {
            const float from = options.fade_from * (1.0f - own.figure[s].y * (1.0f - dot));
            left[s] = std::clamp((scores[s] - from) / (1.0f - from), 0.0f, 1.0f);
        }
        const double step = spacing(own, begin, end);
        if (step > 0.0) open(&left[begin], end - begin, std::min(options.stub_px / step, double(end - begin)));
        for (std::size_t s = begin; s < end; ++s) opacities[own.sample[s]] = left[s] < options.cut ? 0.0f : left[s];
    });
    return opacities;
}

}  // namespace fovea::elision
