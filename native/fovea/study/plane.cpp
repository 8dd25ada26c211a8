// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/plane.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>

namespace fovea::study {
namespace {

/// Consecutive pixels along an axis, with their weights, that a new one is the mean of.
struct Taps {
    int first = 0;
    std::vector<float> weights;
};

std::vector<Taps> taps_along(int from, int to) {
    const double scale = double(from) / to, reach = std::max(1.0, scale);
    std::vector<Taps> all;
    for (int i = 0; i < to; ++i) {
        const double middle = (i + 0.5) * scale - 0.5;
        const int first = std::max(0, int(std::ceil(middle - reach))),
                  last = std::min(from - 1, int(std::floor(middle + reach)));
        std::vector<double> weights;
        double sum = 0.0;
        for (int k = first; k <= last; ++k) sum += weights.emplace_back(1.0 - std::abs(k - middle) / reach);
        Taps taps{first, {}};
        for (const double weight : weights) taps.weights.push_back(float(weight / sum));
        all.push_back(std::move(taps));
    }
    return all;
}

}  // namespace

Plane resized(const Plane& plane, int width, int height) {
    const std::vector<Taps> across = taps_along(plane.width, width), upwards = taps_along(plane.height, height);
    Plane rows(width, plane.height), result(width, height);
    parallel_for(std::size_t(plane.height), 8, [&](std::size_t y) {
        for (int x = 0; x < width; ++x)
            for (int k = 0; const float weight : across[std::size_t(x)].weights)
                rows.at(x, int(y)) += weight * plane.at(across[std::size_t(x)].first + k++, int(y));
    });
    parallel_for(std::size_t(height), 8, [&](std::size_t y) {
        for (int k = 0; const float weight : upwards[y].weights) {
            const int row = upwards[y].first + k++;
            for (int x = 0; x < width; ++x) result.at(x, int(y)) += weight * rows.at(x, row);
        }
    });
    return result;
}

}  // namespace fovea::study
