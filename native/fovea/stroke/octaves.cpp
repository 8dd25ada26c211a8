// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/octaves.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include <fovea/stroke/fragment.h>

namespace fovea::stroke {

namespace {

constexpr int most_samples = 160, halvings = 14;
constexpr float most_shift = 0.5f;

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
    const auto key = [&](Index k) { return std::pair(level[k], to_less[k] - to_more[k]); };
    std::vector<Index> order(level.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::ranges::stable_sort(order, {}, key);
    for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
        while (end < order.size() && key(order[end]) == key(order[first])) ++end;
        for (std::size_t k = first; k < end; ++k)
            ranks[order[k]] = float(0.5 * double(first + end) / double(order.size()));
    }
}

/// The shift with which the ink of these ranks has this mean; `ascending`: it grows with ranks.
float shift_to(float mean, bool ascending, formulas::Stroke stroke, In<float> ranks, int row) {
    float below = -most_shift, above = most_shift;
    for (int k = 0; k < halvings; ++k) {
        const float middle = 0.5f * (below + above);
        double sum = 0.0;
        for (const float rank : ranks) sum += stroke.ranked_ink(0, stroke.size(), rank + middle, row);
        ((sum < double(mean) * double(ranks.size())) == ascending ? below : above) = middle;
    }
    return 0.5f * (below + above);
}

double mean_of(In<float> ink) { return std::accumulate(ink.begin(), ink.end(), 0.0) / double(ink.size()); }

Array<float> octaves_of_dashes(const PenTexture& fitted) {
    const std::size_t width = std::size_t(fitted.width), height = std::size_t(fitted.height);
    const int steps = formulas::Stroke{}.octave_steps();
    const bool ascending = mean_of(fitted.ink) >= 0.5;
    PenTexture made{fitted.width, fitted.height, {}};
    made.octaves.resize(2 * width * height + height * std::size_t(steps + 1));
    float *const ranks = made.octaves.data(), *const sorted = ranks + width * height,
                 *const shifts = sorted + width * height;
    for (int row = 0; row < fitted.height; ++row) {
        std::vector<int> level;
        for (const float ink : fitted.row(row))
            level.push_back(int(std::lround(ascending ? 255.0f * ink : -255.0f * ink)));
        rank(level, ranks + std::size_t(row) * width);
        float* const first = sorted + std::size_t(row) * width;
        std::ranges::copy(fitted.row(row), first);
        std::sort(first, first + width, [&](float a, float b) { return ascending ? a < b : a > b; });
    }
    formulas::Stroke stroke{&made};
    // Places between texels, too, in two repetitions of the finer octave, which are one of the coarser.
    const int places = 4 * fitted.width, stride = (places / most_samples) | 1;
    std::vector<float> found;
    for (int row = 0; row < fitted.height; ++row) {
        float* const of_row = shifts + row * (steps + 1);
        for (int k = 0; k <= steps; ++k) {
            found.clear();
            for (int place = 0; place < places; place += stride)
                found.push_back(stroke.octave_rank(0, stroke.size(), 2.0f * (float(place) + 0.5f) / float(places),
                                                   float(k) / float(steps), row));
            of_row[k] = shift_to(float(mean_of(fitted.row(row))), ascending, stroke, found, row);
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
    for (int row = 0; row < fitted.height; ++row) means.push_back(float(mean_of(fitted.row(row))));
    return means;
}

}  // namespace fovea::stroke
