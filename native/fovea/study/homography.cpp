// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/homography.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/base/steps.h>

namespace fovea::study {
namespace {

constexpr double least_pivot = 1e-13;  // as a share of its diagonal entry
constexpr int most_samples = 8;        // of a pixel, along a side

/// Moves points about their mean, and to a mean distance of 1 from it.
Homography normalizing(In<dvec2> points) {
    dvec2 mean(0.0);
    for (const dvec2& p : points) mean += p / double(points.size());
    double distance = 0.0;
    for (const dvec2& p : points) distance += glm::distance(p, mean) / double(points.size());
    const double scale = distance > 0.0 ? 1.0 / distance : 1.0;
    return {scale, 0.0, 0.0, 0.0, scale, 0.0, -scale * mean.x, -scale * mean.y, 1.0};
}

double bilinear(const color::GrayImage& picture, const dvec2& at) {
    const auto value = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return double(white);
        return double(picture.values[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)]);
    };
    const bool is_near = std::abs(at.x) < 1e6 && std::abs(at.y) < 1e6;
    if (!is_near) return white;
    const dvec2 low = glm::floor(at - 0.5), t = at - 0.5 - low;
    const int x = int(low.x), y = int(low.y);
    return std::lerp(std::lerp(value(x, y), value(x + 1, y), t.x), std::lerp(value(x, y + 1), value(x + 1, y + 1), t.x),
                     t.y);
}

}  // namespace

void NormalEquations::add(const std::array<double, 8>& row, double value, double weight) {
    for (std::size_t i = 0; i < 8; ++i) {
        for (std::size_t k = 0; k < 8; ++k) matrix[i][k] += weight * row[i] * row[k];
        right[i] += weight * row[i] * value;
    }
}

std::optional<std::array<double, 8>> NormalEquations::solved() const {
    auto a = matrix;
    auto b = right;
    for (std::size_t i = 0; i < 8; ++i) {
        if (!(a[i][i] > least_pivot * matrix[i][i])) return std::nullopt;
        for (std::size_t k = i + 1; k < 8; ++k) {
            const double factor = a[k][i] / a[i][i];
            for (std::size_t j = i; j < 8; ++j) a[k][j] -= factor * a[i][j];
            b[k] -= factor * b[i];
        }
    }
    for (std::size_t i = 8; i-- > 0;) {
        for (std::size_t j = i + 1; j < 8; ++j) b[i] -= a[i][j] * b[j];
        b[i] /= a[i][i];
    }
    return b;
}

std::optional<Homography> homography_of(In<dvec2> from, In<dvec2> to) {
    check(from.size() == to.size() && from.size() >= 4, "a homography needs four pairs of points");
    const Homography first = normalizing(from), last = normalizing(to);
    NormalEquations equations;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const dvec2 p = mapped(first, from[i]), q = mapped(last, to[i]);
        equations.add({p.x, p.y, 1.0, 0.0, 0.0, 0.0, -q.x * p.x, -q.x * p.y}, q.x, 1.0);
        equations.add({0.0, 0.0, 0.0, p.x, p.y, 1.0, -q.y * p.x, -q.y * p.y}, q.y, 1.0);
    }
    const auto h = equations.solved();
    if (!h) return std::nullopt;
    const auto& v = *h;
    const Homography between(v[0], v[3], v[6], v[1], v[4], v[7], v[2], v[5], 1.0);
    return glm::inverse(last) * between * first;
}

color::GrayImage resampled(const color::GrayImage& picture, const Homography& to_picture, int width, int height) {
    check(width > 0 && height > 0, "a drawing needs pixels");
    color::GrayImage made{width, height, Array<std::uint8_t>(std::size_t(width) * std::size_t(height))};
    const dvec2 middle(0.5 * width, 0.5 * height);
    const double scale = glm::distance(mapped(to_picture, middle), mapped(to_picture, middle + dvec2(1.0)));
    const int samples = steps_of(scale + 1.0, most_samples);
    parallel_for(std::size_t(height), 8, [&](std::size_t y) {
        for (std::size_t x = 0; x < std::size_t(width); ++x) {
            double sum = 0.0;
            for (int j = 0; j < samples; ++j)
                for (int i = 0; i < samples; ++i) {
                    const dvec2 at(double(x) + (i + 0.5) / samples, double(y) + (j + 0.5) / samples);
                    sum += bilinear(picture, mapped(to_picture, at));
                }
            made.values[y * std::size_t(width) + x] = std::uint8_t(std::lround(sum / (samples * samples)));
        }
    });
    return made;
}

}  // namespace fovea::study
