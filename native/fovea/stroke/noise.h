// SPDX-License-Identifier: GPL-3.0-or-later
// Noise along strokes: the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>

#include <fovea/base/types.h>

namespace fovea::stroke {

/// Hash of an integer (splitmix64, Steele et al. 2014).
inline std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// Noise in [-1,1] at integers.
inline double lattice(std::int64_t i, std::uint64_t seed) {
    return double(mixed(seed ^ mixed(std::uint64_t(i))) >> 11) * 0x1p-52 - 1.0;
}

/// Smooth noise in [-1,1]: value noise with a continuous second derivative.
inline double noise(double x, std::uint64_t seed) {
    const double below = std::floor(x), t = x - below;
    const double s = t * t * t * (t * (6.0 * t - 15.0) + 10.0);
    return glm::mix(lattice(std::int64_t(below), seed), lattice(std::int64_t(below) + 1, seed), s);
}

/// Two octaves of smooth noise in [-1,1], the second half as long and half as high.
inline double two_octaves(double x, std::uint64_t seed) { return (2.0 * noise(x, seed) + noise(2.0 * x, ~seed)) / 3.0; }

}  // namespace fovea::stroke
