// SPDX-License-Identifier: GPL-3.0-or-later
// The transforms are separable sums: of 64 rows they take milliseconds, for which no library is needed.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/image/gaussian.h>
#include <fovea/study/complex_product.h>
#include <fovea/study/salience.h>

namespace fovea::study {
namespace {

constexpr int rows = 64, most_columns = 256;
constexpr double sigma = 2.5;         // cells by which the map is blurred
constexpr double least = 1e-3;        // amplitude that rounding does not make
constexpr double least_share = 1e-3;  // of the largest amplitude: below is what rounding to bytes makes

using Complex = std::complex<double>;
using Spectrum = std::vector<Complex>;  // width x height, row by row

/// The discrete Fourier transform along rows of `width` values, transposed. `sign`: -1, or 1 of the inverse one.
Spectrum transformed_rows(const Spectrum& of, int width, int height, double sign) {
    std::vector<Complex> waves;
    for (int k = 0; k < width; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / width;
        waves.emplace_back(cosine(angle), sign * sine(angle));
    }
    Spectrum found(of.size());
    parallel_for(std::size_t(width), 4, [&](std::size_t u) {
        for (std::size_t y = 0; y < std::size_t(height); ++y) {
            Complex sum;
            for (std::size_t x = 0; x < std::size_t(width); ++x)
                sum += product(of[y * std::size_t(width) + x], waves[u * x % std::size_t(width)]);
            found[u * std::size_t(height) + y] = sum;
        }
    });
    return found;
}

Spectrum transformed(const Spectrum& of, int width, int height, double sign) {
    return transformed_rows(transformed_rows(of, width, height, sign), height, width, sign);
}

/// Mean of 3 x 3 values, around the borders.
std::vector<double> smoothed(const std::vector<double>& of, int width, int height) {
    std::vector<double> found(of.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int v = y - 1; v <= y + 1; ++v)
                for (int u = x - 1; u <= x + 1; ++u)
                    found[std::size_t(y * width + x)] +=
                        of[std::size_t((v + height) % height * width + (u + width) % width)] / 9.0;
    return found;
}

/// Energy at each cell of what is left of a channel where the amplitudes of its spectrum are divided by what they are
/// around.
void add_energy(const Plane& channel, Plane& sum) {
    const int width = channel.width, height = channel.height;
    Spectrum spectrum = transformed({channel.values.begin(), channel.values.end()}, width, height, -1.0);
    spectrum[0] = 0.0;  // the mean is no difference
    double largest = 0.0;
    for (const Complex& each : spectrum) largest = std::max(largest, std::abs(each));
    if (!(largest > least)) return;
    std::vector<double> amplitudes;
    for (const Complex& each : spectrum)
        amplitudes.push_back(logarithm(std::max(std::abs(each), least_share * largest)));
    const std::vector<double> around = smoothed(amplitudes, width, height);
    for (std::size_t i = 0; i < spectrum.size(); ++i) spectrum[i] *= exponential(-around[i]);
    const Spectrum left = transformed(spectrum, width, height, 1.0);
    for (std::size_t i = 0; i < left.size(); ++i) sum.values[i] += float(std::norm(left[i]));
}

}  // namespace

Plane spectral_residual(const color::RgbImage& picture) {
    const int width = std::clamp(int(std::lround(double(rows) * picture.width / picture.height)), 1, most_columns);
    const Channels channels = channels_of(picture, width, rows);
    Plane energy(width, rows);
    for (const Plane* channel : {&channels.intensity, &channels.red_green, &channels.blue_yellow})
        add_energy(*channel, energy);
    energy.values = image::gaussian(energy.values, width, rows, sigma);
    return energy;
}

}  // namespace fovea::study
