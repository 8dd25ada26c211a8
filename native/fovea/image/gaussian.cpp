// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/image/gaussian.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>

namespace fovea::image {
namespace {

/// Weights from the center outwards; the whole symmetric kernel sums to 1.
std::vector<float> half_kernel(double sigma) {
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = 0; i <= static_cast<int>(std::ceil(3.5 * sigma)); ++i) {
        weights.push_back(exponential(-0.5 * i * i / (sigma * sigma)));
        sum += (i ? 2.0 : 1.0) * weights.back();
    }
    std::vector<float> kernel;
    for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
    return kernel;
}

}  // namespace

Buffer gaussian(const Buffer& values, int width, int height, double sigma) {
    const std::vector<float> kernel = half_kernel(sigma);
    const int reach = static_cast<int>(kernel.size()) - 1;
    Buffer across(values.size()), result(values.size());
    parallel_blocks(height, 8, [&](std::size_t, std::size_t begin, std::size_t end) {
        Buffer padded(width + 2 * reach);
        for (std::size_t y = begin; y < end; ++y) {
            const float* row = &values[y * width];
            std::fill_n(padded.begin(), reach, row[0]);
            std::copy_n(row, width, padded.begin() + reach);
            std::fill_n(padded.begin() + reach + width, reach, row[width - 1]);
            float* out = &across[y * width];
            const float* middle = padded.data() + reach;
            for (int x = 0; x < width; ++x) out[x] = kernel[0] * middle[x];
            for (int k = 1; k <= reach; ++k)
                for (int x = 0; x < width; ++x) out[x] += kernel[k] * (middle[x - k] + middle[x + k]);
        }
    });
    parallel_blocks(height, 8, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (int y = int(begin); y < int(end); ++y) {
            const auto row = [&](int j) { return &across[std::size_t(std::clamp(j, 0, height - 1)) * width]; };
            float* out = &result[std::size_t(y) * width];
            for (int x = 0; x < width; ++x) out[x] = kernel[0] * row(y)[x];
            for (int k = 1; k <= reach; ++k) {
                const float *below = row(y - k), *above = row(y + k);
                for (int x = 0; x < width; ++x) out[x] += kernel[k] * (below[x] + above[x]);
            }
        }
    });
    return result;
}

}  // namespace fovea::image
