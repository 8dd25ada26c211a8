// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/cutout/opacity.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>

namespace fovea::cutout {
namespace {

/// Images with numbers that are none, or endless, have means and an order, too.
float bounded(float texel) { return std::isnan(texel) ? 0.0f : std::clamp(texel, -1e6f, 1e6f); }

int floor_mod(int a, int n) { return (a % n + n) % n; }

/// Index of the texel that stands at place `i`; -1: none.
int extended(int i, int size, Extension extension) {
    if (0 <= i && i < size) return i;
    if (extension == Extension::clip) return -1;
    if (extension == Extension::extend) return std::clamp(i, 0, size - 1);
    if (extension == Extension::repeat) return floor_mod(i, size);
    const int there = floor_mod(i, 2 * size);
    return std::min(there, 2 * size - 1 - there);
}

/// How much of each of `from` texels each of `to` fewer ones covers.
struct Cover {
    double scale;
    int from;
    Cover(int from, int to) : scale(double(from) / to), from(from) {}
    template <typename Give>
    void each(int texel, const Give& give) const {
        const double begin = texel * scale, end = begin + scale;
        for (int i = int(begin); i < std::min(int(std::ceil(end)), from); ++i)
            give(i, std::min(end, i + 1.0) - std::max(begin, double(i)));
    }
};

/// Samples of the image's interpolation.
Array<float> samples_of(const Opacity& image) {
    constexpr int side = 4;  // per texel
    Array<float> samples(std::size_t(image.width) * image.height * side * side);
    parallel_for(image.height, 16, [&](std::size_t y) {
        float* sample = &samples[y * image.width * side * side];
        for (int x = 0; x < image.width; ++x) {
            const float a = image.at(x, int(y)), b = image.at(x + 1, int(y));
            const float c = image.at(x, int(y) + 1), d = image.at(x + 1, int(y) + 1);
            for (int i = 0; i < side * side; ++i) {
                const float u = (i % side + 0.5f) / side, v = (i / side + 0.5f) / side;  // from one center to the next
                *sample++ = glm::mix(glm::mix(a, b, u), glm::mix(c, d, u), v);
            }
        }
    });
    return samples;
}

/// Share of an image that is opaque.
double share_of(const Opacity& image) {
    const Array<float> samples = samples_of(image);
    const auto opaque = [&](float value) { return value > image.threshold; };
    return double(std::count_if(samples.begin(), samples.end(), opaque)) / double(samples.size());
}

/// The threshold with which this share of an image is opaque.
float threshold_for(const Opacity& image, double share) {
    if (share <= 0.0 || share >= 1.0) return image.threshold;
    Array<float> samples = samples_of(image);
    const auto count = std::ptrdiff_t(samples.size());
    const auto below = std::clamp(std::ptrdiff_t((1.0 - share) * double(count)), std::ptrdiff_t(0), count - 1);
    std::nth_element(samples.begin(), samples.begin() + below, samples.end());
    return samples[below];
}

}  // namespace

float Opacity::at(int x, int y) const {
    const int u = extended(x, width, extension), v = extended(y, height, extension);
    return u < 0 || v < 0 ? 0.0f : bounded(texels[std::size_t(v) * width + u]);
}

Opacity halved(const Opacity& opacity) {
    Opacity half = opacity;
    half.width = std::max(opacity.width / 2, 1);
    half.height = std::max(opacity.height / 2, 1);
    half.texels.resize(std::size_t(half.width) * half.height);
    const Cover across(opacity.width, half.width), up(opacity.height, half.height);
    parallel_for(half.height, 64, [&](std::size_t y) {
        for (int x = 0; x < half.width; ++x) {
            double sum = 0.0, weight = 0.0;
            up.each(int(y), [&](int v, double of_row) {
                across.each(x, [&](int u, double of_texel) {
                    sum += of_row * of_texel * bounded(opacity.texels[std::size_t(v) * opacity.width + u]);
                    weight += of_row * of_texel;
                });
            });
            half.texels[y * half.width + x] = static_cast<float>(sum / weight);
        }
    });
    half.threshold = threshold_for(half, share_of(opacity));
    return half;
}

}  // namespace fovea::cutout
