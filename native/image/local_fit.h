// Derivatives of a buffer at a node.
#pragma once

#include <cmath>

#include "image/lattice.h"

namespace fovea {

/// First and second derivatives, per step.
struct LocalFit {
    vec2 gradient{0.0f};
    float xx = 0.0f, xy = 0.0f, yy = 0.0f;

    /// Second derivative along the gradient, times its length squared.
    float along_gradient() const {
        return gradient.x * gradient.x * xx + 2.0f * gradient.x * gradient.y * xy + gradient.y * gradient.y * yy;
    }
};

/// A direction in which the values bend, and how much.
struct Bend {
    vec2 direction{0.0f};    ///< unit; zero where they bend nowhere. Its sign means nothing.
    float curvature = 0.0f;
};

/// The quadratic polynomial that fits the 3 x 3 nodes around an inner node best. Haralick, "Digital Step Edges from
/// Zero Crossing of Second Directional Derivatives", PAMI 1984.
inline LocalFit fit_at(const Buffer& values, const Lattice& lattice, int x, int y) {
    float v[3][3];
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) v[j][i] = values[lattice.at(x + i - 1, y + j - 1)];
    LocalFit fit;
    for (int k = 0; k < 3; ++k) {
        fit.gradient += vec2(v[k][2] - v[k][0], v[2][k] - v[0][k]) / 6.0f;
        fit.xx += (v[k][0] - 2.0f * v[k][1] + v[k][2]) / 3.0f;
        fit.yy += (v[0][k] - 2.0f * v[1][k] + v[2][k]) / 3.0f;
    }
    fit.xy = 0.25f * (v[2][2] - v[2][0] - v[0][2] + v[0][0]);
    return fit;
}

/// The direction of the greatest principal curvature (valleys), or with sign -1 of the least (ridges) turned around:
/// there `curvature` is positive, too.
inline Bend greatest_bend(const LocalFit& fit, float sign) {
    const float mean = 0.5f * sign * (fit.xx + fit.yy), half = 0.5f * sign * (fit.xx - fit.yy), xy = sign * fit.xy;
    const float radius = std::sqrt(half * half + xy * xy);
    // Of the two ways to write an eigenvector the one that does not cancel.
    const vec2 direction = half >= 0.0f ? vec2(half + radius, xy) : vec2(xy, radius - half);
    const float length = glm::length(direction);
    return {length > 0.0f ? direction / length : vec2(0.0f), mean + radius};
}

}  // namespace fovea
