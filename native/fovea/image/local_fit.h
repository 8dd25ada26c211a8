// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of a buffer at a node, by finite differences.
#pragma once

#include <cmath>

#include <fovea/image/lattice.h>

namespace fovea::image {

/// First and second derivatives, per step and per squared step.
struct LocalFit {
    vec2 gradient{0.0f};
    float xx = 0.0f, xy = 0.0f, yy = 0.0f;

    /// Derivative, along the gradient direction, of the logarithm of the gradient's length; linear across a blurred
    /// step edge. 0 where the gradient is zero.
    float growth_of_slope() const {
        const float slope = glm::length(gradient);
        const vec2 d = slope > 0.0f ? gradient / slope : vec2(0.0f);
        return slope > 0.0f ? (d.x * d.x * xx + 2.0f * d.x * d.y * xy + d.y * d.y * yy) / slope : 0.0f;
    }
};

/// Principal direction and curvature.
struct Bend {
    vec2 direction{0.0f};  ///< unit; zero if there is no curvature; sign arbitrary
    float curvature = 0.0f;
};

/// Radius of the stencil of fit_at, in nodes.
inline constexpr int fit_reach = 2;

/// Derivatives at a node at least fit_reach from the border, by central differences of fourth order: no smoothing of
/// their own, and no directional bias. All zero if the four neighbors equal the node.
inline LocalFit fit_at(const Buffer& values, const Lattice& lattice, int x, int y) {
    constexpr float first[5] = {1.0f / 12.0f, -8.0f / 12.0f, 0.0f, 8.0f / 12.0f, -1.0f / 12.0f};
    constexpr float second[5] = {-1.0f / 12.0f, 16.0f / 12.0f, -30.0f / 12.0f, 16.0f / 12.0f, -1.0f / 12.0f};
    const float* v = &values[lattice.at(x, y)];
    const std::ptrdiff_t up = lattice.width;
    LocalFit fit;
    if (v[0] == v[1] && v[0] == v[-1] && v[0] == v[up] && v[0] == v[-up]) return fit;
    for (int i = -2; i <= 2; ++i) {
        fit.gradient += vec2(first[i + 2] * v[i], first[i + 2] * v[i * up]);
        fit.xx += second[i + 2] * v[i];
        fit.yy += second[i + 2] * v[i * up];
        if (i == 0) continue;
        const float* row = v + i * up;
        fit.xy += first[i + 2] * (first[0] * row[-2] + first[1] * row[-1] + first[3] * row[1] + first[4] * row[2]);
    }
    return fit;
}

/// Direction and value of the greatest principal curvature (valleys) for sign 1; for sign -1, of the least one, with
/// its sign flipped (ridges), so that `curvature` is positive there, too.
inline Bend greatest_bend(const LocalFit& fit, float sign) {
    const float mean = 0.5f * sign * (fit.xx + fit.yy), half = 0.5f * sign * (fit.xx - fit.yy), xy = sign * fit.xy;
    const float radius = std::sqrt(half * half + xy * xy);
    // Of the two expressions for the eigenvector, the one without cancellation.
    const vec2 direction = half >= 0.0f ? vec2(half + radius, xy) : vec2(xy, radius - half);
    const float length = glm::length(direction);
    return {length > 0.0f ? direction / length : vec2(0.0f), mean + radius};
}

}  // namespace fovea::image
