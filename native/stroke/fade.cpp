#include "stroke/fade.h"

#include <algorithm>

#include "base/check.h"

namespace fovea {
namespace {

/// The samples of a piece, which follow each other in the atlas.
class Samples {
   public:
    Samples(const ClippedPaths& clipped, In<float> visibility, Index piece, bool hidden)
        : clipped_(clipped), visibility_(visibility), hidden_(hidden) {
        first_point_ = clipped.pieces.begin(piece);
        last_point_ = clipped.pieces.end(piece) - 1;
        begin_ = clipped.sample_start[first_point_];
        end_ = begin_;
        for (Index i = first_point_; i < last_point_; ++i) end_ += clipped.sample_count[i];
    }

    /// Samples are numbered from 0.
    std::ptrdiff_t count() const { return end_ - begin_; }

    float share(std::ptrdiff_t sample) const {
        const float read = visibility_[begin_ + sample];
        const float seen = read > 0.0f ? std::min(read, 1.0f) : 0.0f;  // also what is not a number
        return hidden_ ? 1.0f - seen : seen;
    }

    double arc(std::ptrdiff_t sample) const {
        const Index wanted = begin_ + Index(sample);
        const auto starts = clipped_.sample_start.begin();
        // The last segment that starts at or before the sample; those without samples start with the next.
        const auto after = std::upper_bound(starts + first_point_, starts + last_point_, wanted);
        const Index i = Index(after - starts) - 1;
        const double step = (clipped_.arc_px[i + 1] - clipped_.arc_px[i]) / clipped_.sample_count[i];
        return clipped_.arc_px[i] + (wanted - clipped_.sample_start[i] + 0.5) * step;
    }

    /// The first sample beyond an arc length.
    std::ptrdiff_t after(double arc_px) const {
        std::ptrdiff_t low = 0, high = count();
        while (low < high) {
            const std::ptrdiff_t middle = (low + high) / 2;
            (arc(middle) > arc_px ? high : low) = arc(middle) > arc_px ? middle : middle + 1;
        }
        return low;
    }

   private:
    const ClippedPaths& clipped_;
    In<float> visibility_;
    bool hidden_;
    Index first_point_, last_point_, begin_, end_;
};

/// The samples at which a fade bends, first .. last; none where a run ends sharply.
struct Bends {
    std::ptrdiff_t first = 0, last = -1;
};

/// Those around the end of a run whose last sample is `inner`; `way` (1 or -1) leads out of it.
Bends bends_at(const Samples& samples, std::ptrdiff_t inner, int way) {
    const auto inside = [&](std::ptrdiff_t s) { return s >= 0 && s < samples.count(); };
    const auto partial = [&](std::ptrdiff_t s) { return inside(s) && samples.share(s) > 0.0f && samples.share(s) < 1.0f; };
    std::ptrdiff_t in = inner, out = inner + way;
    while (partial(in)) in -= way;
    while (partial(out)) out += way;
    if (in == inner && out == inner + way) return {};
    // Whole inside and nothing outside, unless filters or the end of the piece say otherwise.
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

void insert_bends(CentreLine& line, const Fade& fade) {
    // Samples of a small picture lie close together: without the last bend before an end, all of the line would fade.
    if (!fade.arc.empty() && line.size() > 1) insert_points(line, fade.arc, 0.1);
}

void fade_ends(CentreLine& line, const Fade& fade) {
    if (fade.arc.empty()) return;
    for (CentrePoint& p : line) {
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

}  // namespace fovea
