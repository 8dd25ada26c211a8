// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/octaves.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <fovea/stroke/fragment.h>
#include <fovea/stroke/ink.h>

namespace fovea::stroke {

namespace {

constexpr int most_samples = 96;  // of two repetitions, by which a row's shift is found

/// Of each value of a circle the distance to the nearest one that comes before it in this order; their number if none
/// does.
template <class Before>
std::vector<int> distances(const std::vector<int>& circle, Before before) {
    const int count = int(circle.size());
    std::vector<int> nearest(circle.size(), count), open;
    for (const int way : {1, -1}) {
        open.clear();
        for (int step = 0; step < 2 * count; ++step) {  // twice round: what is behind the first one comes first
            const auto at = [&](int k) { return circle[std::size_t(way > 0 ? k % count : count - 1 - k % count)]; };
            while (!open.empty() && !before(at(open.back()), at(step))) open.pop_back();
            if (!open.empty() && step >= count) {
                int& least = nearest[std::size_t(way > 0 ? step - count : 2 * count - 1 - step)];
                least = std::min(least, step - open.back());
            }
            open.push_back(step);
        }
    }
    return nearest;
}

/// Ranks of a row's texels by their level, least first.
void rank(const std::vector<int>& level, float* ranks) {
    const std::vector<int> to_less = distances(level, std::less<>()), to_more = distances(level, std::greater<>());
    const std::uint64_t count = level.size();
    std::vector<std::uint64_t> order;  // level, then distance, then column
    for (std::uint64_t k = 0; k < count; ++k)
        order.push_back((std::uint64_t(level[k]) * (2 * count + 1) + (count + to_less[k] - to_more[k])) * count + k);
    std::ranges::sort(order);
    for (std::size_t first = 0, end = 0; first < count; first = end) {
        while (end < count && order[end] / count == order[first] / count) ++end;
        for (std::size_t k = first; k < end; ++k)
            ranks[order[k] % count] = float(0.5 * double(first + end) / double(count));
    }
}

/// The value that a share of them is below.
float quantile(Array<float>& values, double share) {
    std::ranges::sort(values);
    const double at = std::clamp(share * double(values.size()) - 0.5, 0.0, double(values.size() - 1));
    const std::size_t below = std::min(std::size_t(at), values.size() - 1),
                      above = std::min(below + 1, values.size() - 1);
    return glm::mix(values[below], values[above], float(at - double(below)));
}

Array<float> octaves_of_dashes(const PenTexture& fitted) {
    const std::size_t width = std::size_t(fitted.width), height = std::size_t(fitted.height);
    const int steps = formulas::Stroke{}.octave_steps();
    PenTexture made{fitted.width, fitted.height, {}};
    made.octaves.resize(2 * width * height + height * std::size_t(steps + 1));
    float *const ranks = made.octaves.data(), *const sorted = ranks + width * height,
                 *const shifts = sorted + width * height;
    for (int row = 0; row < fitted.height; ++row) {
        std::vector<int> level;
        for (const float ink : fitted.row(row)) level.push_back(int(std::lround(255.0f * ink)));
        rank(level, ranks + std::size_t(row) * width);
        float* const first = sorted + std::size_t(row) * width;
        std::ranges::copy(fitted.row(row), first);
        std::sort(first, first + width);
    }
    formulas::Stroke stroke{&made};
    // Places between texels, too, in two repetitions of the finer octave, which are one of the coarser.
    const int places = 4 * fitted.width, stride = (places / most_samples) | 1;
    Array<float> found;
    for (int row = 0; row < fitted.height; ++row) {
        const double gaps = 1.0 - mean_ink(fitted.row(row));
        float* const of_row = shifts + row * (steps + 1);
        for (int k = 0; k <= steps; ++k) {
            found.clear();
            for (int place = 0; place < places; place += stride)
                found.push_back(stroke.octave_rank(0, stroke.size(), 2.0f * (float(place) + 0.5f) / float(places),
                                                   float(k) / float(steps), row));
            of_row[k] = float(gaps) - quantile(found, gaps);
        }
        // The coarser octave alone is the finer one of the octave before.
        of_row[0] = of_row[steps] = 0.5f * (of_row[0] + of_row[steps]);
    }
    return std::move(made.octaves);
}

}  // namespace

Array<float> octaves_of(const PenTexture& fitted) {
    if (fitted.dashed) return octaves_of_dashes(fitted);
    Array<float> means;
    for (int row = 0; row < fitted.height; ++row) means.push_back(float(mean_ink(fitted.row(row))));
    return means;
}

float anchored_ink(const PenTexture& texture, float along, float v, float half_width, float path_px,
                   float texture_length_px) {
    formulas::Stroke stroke{&texture};
    return stroke.anchored_stroke_ink(0, stroke.size(), texture.dashed, along, v, half_width, path_px,
                                      texture_length_px);
}

}  // namespace fovea::stroke
