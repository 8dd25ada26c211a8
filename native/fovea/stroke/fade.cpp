// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/fade.h>

#include <algorithm>

#include <fovea/visibility/piece_samples.h>

namespace fovea::stroke {
namespace {

/// Opacity factor of a run at each sample of its piece.
class Samples : public PieceSamples {
   public:
    Samples(const ClippedPaths& clipped, In<float> visibility, Index piece, bool hidden)
        : PieceSamples(clipped, piece), visibility_(visibility), hidden_(hidden) {}

    float share(std::ptrdiff_t sample) const {
        const float read = visibility_[in_atlas(sample)];
        const float seen = read > 0.0f ? std::min(read, 1.0f) : 0.0f;  // NaN: 0
        return hidden_ ? 1.0f - seen : seen;
    }

   private:
    In<float> visibility_;
    bool hidden_;
};

/// The samples that are knots of a fade, first .. last; empty for a sharp end.
struct Bends {
    std::ptrdiff_t first = 0, last = -1;
};

/// Knots around the end of a run whose last sample is `inner`; `way` (1 or -1) points out of the run.
Bends bends_at(const Samples& samples, std::ptrdiff_t inner, int way) {
    const auto inside = [&](std::ptrdiff_t s) { return s >= 0 && s < samples.count(); };
    const auto partial = [&](std::ptrdiff_t s) {
        return inside(s) && samples.share(s) > 0.0f && samples.share(s) < 1.0f;
    };
    std::ptrdiff_t in = inner, out = inner + way;
    while (partial(in)) in -= way;
    while (partial(out)) out += way;
    if (in == inner && out == inner + way) return {};
    // Includes a fully shown sample inside and a fully hidden one outside, unless filters moved the end or the piece
    // ends.
    if (!inside(in) || samples.share(in) < 1.0f) in += way;
    if (!inside(out) || samples.share(out) > 0.0f) out -= way;
    return {std::min(in, out), std::max(in, out)};
}

}  // namespace

void find_fade(const ClippedPaths& clipped, In<float> visibility, Index piece, double start_px, double end_px,
               bool hidden, Fade& out) {
    out.arc.clear();
    out.share.clear();
    out.at_start = out.at_end = false;
    out.start_px = start_px;
    out.end_px = end_px;
    if (visibility.empty() || clipped.pieces.size(piece) < 2) return;
    const Samples samples(clipped, visibility, piece, hidden);
    const std::ptrdiff_t first = samples.after(start_px), beyond = samples.after(end_px);
    const Bends at_start = bends_at(samples, first, -1), at_end = bends_at(samples, beyond - 1, 1);
    const auto add = [&](std::ptrdiff_t s) {
        out.arc.push_back(samples.arc(s));
        out.share.push_back(samples.share(s));
    };
    for (std::ptrdiff_t s = at_start.first; s <= at_start.last; ++s) add(s);
    for (std::ptrdiff_t s = std::max(at_end.first, at_start.last + 1); s <= at_end.last; ++s) add(s);
    if (out.arc.empty()) return;
    out.at_start = at_start.first <= at_start.last;
    out.at_end = at_end.first <= at_end.last;
    if (out.at_start) out.start_px = std::min(start_px, samples.arc(at_start.first));
    if (out.at_end) out.end_px = std::max(end_px, samples.arc(at_end.last));
}

void insert_bends(CenterLine& line, const Fade& fade) {
    // Small tolerance, as samples of a small picture lie close together: without the last knot before an end, all of
    // the line would fade.
    if (!fade.arc.empty() && line.size() > 1) insert_points(line, fade.arc, 0.1);
}

void fade_ends(CenterLine& line, const Fade& fade) {
    if (fade.arc.empty()) return;
    for (CenterPoint& p : line) {
        const auto above = std::upper_bound(fade.arc.begin(), fade.arc.end(), p.arc);
        const std::size_t k = above - fade.arc.begin();
        if (k == 0) {
            p.opacity *= fade.at_start ? fade.share.front() : 1.0f;
        } else if (k == fade.arc.size()) {
            p.opacity *= fade.at_end ? fade.share.back() : 1.0f;
        } else {
            const double t = (p.arc - fade.arc[k - 1]) / (fade.arc[k] - fade.arc[k - 1]);
            p.opacity *= glm::mix(fade.share[k - 1], fade.share[k], float(t));
        }
    }
}

}  // namespace fovea::stroke
