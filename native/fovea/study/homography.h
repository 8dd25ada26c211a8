// SPDX-License-Identifier: GPL-3.0-or-later
// Maps of one picture's pixels to another's.
#pragma once

#include <array>
#include <optional>

#include <fovea/color/png.h>
#include <fovea/study/bitmap.h>

namespace fovea::study {

/// Paper around pictures.
inline constexpr std::uint8_t white = 255;

/// Maps the column (x, y, 1) up to a factor.
using Homography = dmat3;

inline dvec2 mapped(const Homography& map, const dvec2& point) {
    const dvec3 to = map * dvec3(point, 1.0);
    return dvec2(to) / to.z;
}

/// Eight equations with eight unknowns, symmetric and positive definite.
struct NormalEquations {
    std::array<std::array<double, 8>, 8> matrix{};
    std::array<double, 8> right{};

    /// Adds the equation row . unknowns = value, squared, with a weight.
    void add(const std::array<double, 8>& row, double value, double weight);
    /// None if they are not determined.
    std::optional<std::array<double, 8>> solved() const;
};

/// The map of four points or more to others, by least squares (the direct linear transform); none if they do not
/// determine it, as where three of four are on a line. Points are some pixels to some thousand apart.
std::optional<Homography> homography_of(In<dvec2> from, In<dvec2> to);

/// A picture of width x height pixels, each with the mean of the parts of `picture` that `to_picture` maps it to;
/// white where that is outside.
color::GrayImage resampled(const color::GrayImage& picture, const Homography& to_picture, int width, int height);

}  // namespace fovea::study
