// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/salience.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/image/gaussian.h>
#include <fovea/study/complex_product.h>

namespace fovea::study {
namespace {

constexpr int centers[] = {2, 3, 4}, apart[] = {3, 4};  // levels of centers, and how many levels above surrounds are
constexpr int levels = 9, map_level = 4;
constexpr int orientations = 4;                       // over half a turn
constexpr double period = 7.0, sigma = period / 3.0;  // of Gabor filters, in pixels of a level
constexpr float darkest = 0.1f;                       // of the brightest: below, colors are not seen
constexpr float least = 1e-3f;                        // differences that cannot be seen
constexpr float least_peak = 0.1f, tie = 1e-3f;  // of the highest one: below there is none; differences of equal cells

using Pyramid = std::vector<Plane>;

/// Levels, each half as wide as the one before: Gaussian, by the binomial filter 1 3 3 1.
Pyramid pyramid_of(Plane picture) {
    Pyramid pyramid{std::move(picture)};
    while (pyramid.size() < levels) {
        const Plane& last = pyramid.back();
        pyramid.push_back(resized(last, (last.width + 1) / 2, (last.height + 1) / 2));
    }
    return pyramid;
}

/// Amplitude of a wave across each pixel whose crests are turned by `angle`, without the mean.
Plane gabor(const Plane& plane, double angle) {
    constexpr int reach = 9;  // that of image::gaussian
    using Complex = std::complex<float>;
    const double across = std::numbers::pi * 2.0 / period * cosine(angle),
                 upwards = std::numbers::pi * 2.0 / period * sine(angle);
    double whole = 0.0;
    for (int k = -reach; k <= reach; ++k) whole += exponential(-0.5 * k * k / (sigma * sigma));
    const auto kernel = [&](double frequency) {
        std::array<Complex, 2 * reach + 1> taps;
        for (int k = -reach; k <= reach; ++k) {
            const double weight = exponential(-0.5 * k * k / (sigma * sigma)) / whole;
            taps[std::size_t(k + reach)] = {float(weight * cosine(frequency * k)), float(weight * sine(frequency * k))};
        }
        return taps;
    };
    const auto row_taps = kernel(across), column_taps = kernel(upwards);
    Complex row_sum, column_sum;
    for (const Complex& tap : row_taps) row_sum += tap;
    for (const Complex& tap : column_taps) column_sum += tap;
    const float of_mean = product(row_sum, column_sum).real();

    const image::Buffer mean = image::gaussian(plane.values, plane.width, plane.height, sigma);
    std::vector<Complex> rows(plane.values.size());
    Plane result(plane.width, plane.height);
    parallel_for(std::size_t(plane.height), 8, [&](std::size_t y) {
        for (int x = 0; x < plane.width; ++x)
            for (int k = -reach; k <= reach; ++k)
                rows[y * std::size_t(plane.width) + std::size_t(x)] +=
                    row_taps[std::size_t(k + reach)] * plane.at(std::clamp(x + k, 0, plane.width - 1), int(y));
    });
    parallel_for(std::size_t(plane.height), 8, [&](std::size_t y) {
        for (int x = 0; x < plane.width; ++x) {
            const std::size_t i = y * std::size_t(plane.width) + std::size_t(x);
            Complex sum = -of_mean * mean[i];
            for (int k = -reach; k <= reach; ++k) {
                const int row = std::clamp(int(y) + k, 0, plane.height - 1);
                sum += product(column_taps[std::size_t(k + reach)],
                               rows[std::size_t(row) * std::size_t(plane.width) + std::size_t(x)]);
            }
            result.values[i] = std::hypot(sum.real(), sum.imag());
        }
    });
    return result;
}

/// The same pyramid of amplitudes, from the level of the first center on.
Pyramid orientation(const Pyramid& intensity, double angle) {
    Pyramid found(levels);
    for (std::size_t level = centers[0]; level < levels; ++level) found[level] = gabor(intensity[level], angle);
    return found;
}

void add(Plane& sum, const Plane& other, float factor = 1.0f) {
    for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += factor * other.values[i];
}

float highest(const Plane& map) { return *std::ranges::max_element(map.values); }

/// The operator N of Itti, Koch & Niebur: divided by `whole`, and weighted by how far the highest peak is above the
/// mean of the others.
Plane normalized(Plane map, float whole) {
    if (!(whole > least)) return {map.width, map.height};
    for (float& value : map.values) value /= whole;
    // 1 at a peak; of equal neighbors each has a share; 0 elsewhere.
    const auto share_of_peak = [&](int x, int y) {
        int equal = 0;
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, map.height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, map.width - 1); ++u) {
                if (map.at(u, v) > map.at(x, y) + tie) return 0.0;
                equal += map.at(u, v) > map.at(x, y) - tie;
            }
        return map.at(x, y) > least_peak ? 1.0 / equal : 0.0;
    };
    double sum = 0.0, peaks = 0.0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const double share = share_of_peak(x, y);
            sum += share * double(map.at(x, y));
            peaks += share;
        }
    const double most = highest(map), others = peaks > 1.5 ? (sum - most) / (peaks - 1.0) : 0.0;
    for (float& value : map.values) value *= float((most - others) * (most - others));
    return map;
}

Plane normalized(const Plane& map) { return normalized(map, highest(map)); }

float rising(float difference) { return std::max(difference, 0.0f); }
float falling(float difference) { return std::max(-difference, 0.0f); }
float either(float difference) { return std::abs(difference); }

/// Sum of the normalized differences between centers and surrounds, in cells of the map; `parts`: of which each is
/// normalized by itself.
Plane differences(const Pyramid& pyramid, int width, int height, const std::vector<float (*)(float)>& parts) {
    Plane sum(width, height);
    for (const int center : centers)
        for (const int more : apart) {
            Plane difference = pyramid[std::size_t(center)];
            add(difference, resized(pyramid[std::size_t(center + more)], difference.width, difference.height), -1.0f);
            std::vector<Plane> maps;
            float whole = 0.0f;
            for (const auto part : parts) {
                Plane map = difference;
                std::ranges::transform(map.values, map.values.begin(), part);
                whole = std::max(whole, highest(maps.emplace_back(resized(map, width, height))));
            }
            for (Plane& map : maps) add(sum, normalized(std::move(map), whole));
        }
    return sum;
}

}  // namespace

Channels channels_of(const color::RgbImage& picture, int width, int height) {
    Plane bands[3];
    for (std::size_t band = 0; band < 3; ++band) {
        Plane whole(picture.width, picture.height);
        for (std::size_t i = 0; i < whole.values.size(); ++i)
            whole.values[i] = float(picture.values[3 * i + band]) / 255.0f;
        bands[band] = resized(whole, width, height);
    }
    Channels found{{width, height}, {width, height}, {width, height}};
    const auto color = [&](std::size_t i) { return vec3(bands[0].values[i], bands[1].values[i], bands[2].values[i]); };
    const auto most_of = [](const vec3& rgb) { return std::max({rgb.r, rgb.g, rgb.b}); };
    float brightest = 0.0f;
    for (std::size_t i = 0; i < found.intensity.values.size(); ++i) brightest = std::max(brightest, most_of(color(i)));
    for (std::size_t i = 0; i < found.intensity.values.size(); ++i) {
        const vec3 rgb = color(i);
        const float most = most_of(rgb);
        found.intensity.values[i] = (rgb.r + rgb.g + rgb.b) / 3.0f;
        if (!(most > darkest * brightest)) continue;
        found.red_green.values[i] = (rgb.r - rgb.g) / most;
        found.blue_yellow.values[i] = (rgb.b - std::min(rgb.r, rgb.g)) / most;
    }
    return found;
}

Plane itti_koch(const color::RgbImage& picture) {
    const double scale = usual_diagonal / std::hypot(picture.width, picture.height);
    const auto side = [&](int pixels) { return std::max(1, int(std::lround(pixels * scale))); };
    Channels channels = channels_of(picture, side(picture.width), side(picture.height));
    const Pyramid intensity = pyramid_of(std::move(channels.intensity));
    const int width = intensity[map_level].width, height = intensity[map_level].height;
    Plane colors(width, height);
    for (Plane* opponency : {&channels.red_green, &channels.blue_yellow})  // each color by itself: one red among green
        add(colors, differences(pyramid_of(std::move(*opponency)), width, height, {rising, falling}));
    Plane oriented(width, height);
    for (int k = 0; k < orientations; ++k) {
        const double angle = std::numbers::pi * k / orientations;
        add(oriented, normalized(differences(orientation(intensity, angle), width, height, {either})));
    }
    Plane salience(width, height);
    for (const Plane& conspicuity : {differences(intensity, width, height, {either}), colors, oriented})
        add(salience, normalized(conspicuity), 1.0f / 3.0f);
    return salience;
}

}  // namespace fovea::study
