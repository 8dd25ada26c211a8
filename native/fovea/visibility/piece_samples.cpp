// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/piece_samples.h>

#include <algorithm>

namespace fovea::visibility {

PieceSamples::PieceSamples(const ClippedPaths& clipped, Index piece) : clipped_(clipped) {
    first_point_ = clipped.pieces.begin(piece);
    last_point_ = std::max(clipped.pieces.end(piece), first_point_ + 1) - 1;
    begin_ = clipped.first_sample(piece);
    end_ = clipped.first_sample(piece + 1);
}

double PieceSamples::arc(std::ptrdiff_t sample) const {
    const Index wanted = Index(begin_ + sample);
    const auto starts = clipped_.sample_start.begin();
    // The last segment that starts at or before the sample; segments without samples have the start of the next one.
    const auto after = std::upper_bound(starts + first_point_, starts + last_point_, wanted);
    const Index i = Index(after - starts) - 1;
    const double step = (clipped_.arc_px[i + 1] - clipped_.arc_px[i]) / clipped_.sample_count[i];
    return clipped_.arc_px[i] + (wanted - clipped_.sample_start[i] + 0.5) * step;
}

std::ptrdiff_t PieceSamples::after(double arc_px) const {
    std::ptrdiff_t low = 0, high = count();
    while (low < high) {
        const std::ptrdiff_t middle = (low + high) / 2;
        (arc(middle) > arc_px ? high : low) = arc(middle) > arc_px ? middle : middle + 1;
    }
    return low;
}

float PieceSamples::value(In<float> values, double arc_px, float otherwise) const {
    if (count() == 0) return otherwise;
    const std::ptrdiff_t next = after(arc_px);
    if (next == 0) return values[in_atlas(0)];
    if (next == count()) return values[in_atlas(next - 1)];
    const double a = arc(next - 1), b = arc(next);
    return glm::mix(values[in_atlas(next - 1)], values[in_atlas(next)], float((arc_px - a) / (b - a)));
}

}  // namespace fovea::visibility
