// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/probable_lines.h>

#include <cmath>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/parallel.h>
#include <fovea/image/gaussian.h>
#include <fovea/image/local_fit.h>
#include <fovea/study/bitmap.h>
#include <fovea/study/thin.h>

namespace fovea::study {
namespace {

constexpr double line_blur = 1.5;     // px
constexpr float within = 0.6f;        // px from a pixel's middle: no line has gaps
constexpr float least_bend = 0.02f;   // over the blur's width, as a share of the probability
constexpr double low = 0.5;           // of the threshold
constexpr double least_length = 8.0;  // px of a picture of 1024 x 768

/// The sets of neighboring pixels (8 of them) of a bitmap.
DisjointSets joined_of(const Bitmap& bitmap) {
    const int width = bitmap.width, height = bitmap.height;
    DisjointSets joined(bitmap.set.size());
    const auto number = [&](int x, int y) { return std::size_t(y) * std::size_t(width) + std::size_t(x); };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (!bitmap.set[number(x, y)]) continue;
            for (const auto& [i, j] : {std::pair{x + 1, y}, {x - 1, y + 1}, {x, y + 1}, {x + 1, y + 1}})
                if (i >= 0 && i < width && j < height && bitmap.set[number(i, j)])
                    joined.join(Index(number(x, y)), Index(number(i, j)));
        }
    return joined;
}

/// The sets of a bitmap of which the sum of amount(pixel) is at least `least`.
template <typename Amount>
Bitmap sets_with(Bitmap bitmap, double least, const Amount& amount) {
    DisjointSets joined = joined_of(bitmap);
    std::vector<double> sums(bitmap.set.size(), 0.0);
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (bitmap.set[i]) sums[joined.name(Index(i))] += amount(i);
    for (std::size_t i = 0; i < sums.size(); ++i) bitmap.set[i] = bitmap.set[i] && sums[joined.name(Index(i))] >= least;
    return bitmap;
}

}  // namespace

Strengths crests_of(const Plane& probability) {
    const int width = probability.width, height = probability.height;
    const double sigma = line_blur * scale_of(width, height);
    const image::Buffer smooth = image::gaussian(probability.values, width, height, sigma);
    const image::Lattice lattice{dvec2(0.5), 1.0, width, height};
    const auto unit = float(sigma * sigma);
    Strengths found{width, height, Array<float>(smooth.size(), -1.0f)};
    constexpr int border = image::fit_reach;
    if (width <= 2 * border || height <= 2 * border) return found;
    parallel_for(std::size_t(height - 2 * border), 8, [&](std::size_t row) {
        const int y = int(row) + border;
        for (int x = border; x < width - border; ++x) {
            const image::LocalFit fit = image::fit_at(smooth, lattice, x, y);
            const image::Bend bend = image::greatest_bend(fit, -1.0f);
            const float value = smooth[lattice.at(x, y)];
            if (!(value > 0.0f && unit * bend.curvature >= least_bend * value)) continue;
            const vec2 to_crest = bend.direction * (glm::dot(fit.gradient, bend.direction) / bend.curvature);
            if (std::max(std::abs(to_crest.x), std::abs(to_crest.y)) <= within) found.values[lattice.at(x, y)] = value;
        }
    });
    return found;
}

Bitmap lines_of(const Strengths& crests, double threshold) {
    const Bitmap strong = sets_with(crests.above(float(low * threshold)), 1.0,
                                    [&](std::size_t i) { return double(crests.values[i]) >= threshold ? 1.0 : 0.0; });
    const double least = least_length * scale_of(crests.width, crests.height);
    return sets_with(thinned(strong), least, [](std::size_t) { return 1.0; });
}

}  // namespace fovea::study
