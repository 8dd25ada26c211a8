// SPDX-License-Identifier: GPL-3.0-or-later
// Noise along strokes: the same on every machine.
#pragma once

#include <algorithm>
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

/// From 0 to 1 as t does, with two derivatives that are 0 at both ends.
inline double eased(double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); }

/// Smooth noise in [-1,1]: value noise with a continuous second derivative.
inline double noise(double x, std::uint64_t seed) {
    const double below = std::floor(x);
    return glm::mix(lattice(std::int64_t(below), seed), lattice(std::int64_t(below) + 1, seed), eased(x - below));
}

/// Two octaves of smooth noise in [-1,1], the second half as long and half as high.
inline double two_octaves(double x, std::uint64_t seed) { return (2.0 * noise(x, seed) + noise(2.0 * x, ~seed)) / 3.0; }

/// Points of a line to a wavelength of its noise, where these are a pixel or more from each other.
inline constexpr double steps_per_wave = 6.0;

/// Mix of two noises in [-1,1] that do not depend on each other, which strays as far as each of them.
inline double mixed_noises(double a, double b, double share) {
    const double spread = std::sqrt(share * share + (1.0 - share) * (1.0 - share));
    return std::clamp(glm::mix(a, b, share) / spread, -1.0, 1.0);
}

/// Seeds of the noise along a line: that of its own, and that of another drawing of its boil with its share.
struct Hand {
    std::uint64_t own, other = 0;
    double boil = 0.0;

    Hand(std::uint64_t seed) : own(seed) {}
    /// The hand of a drawing of the boil. The first, 0, is the line's own.
    Hand(std::uint64_t seed, double amount, int drawing)
        : own(seed), other(mixed(seed ^ mixed(std::uint64_t(drawing)))), boil(drawing > 0 ? amount : 0.0) {}

    /// The same hand with noise that does not depend on this one.
    Hand stream(std::uint64_t number) const {
        Hand hand = *this;
        hand.own = mixed(own ^ number);
        hand.other = mixed(other ^ number);
        return hand;
    }
};

}  // namespace fovea::stroke
