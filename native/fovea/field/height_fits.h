// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials fitted to heights over planes, by weighted least squares, of several neighborhoods at once.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace fovea::field {

/// How many coefficients a polynomial of this degree in x and y has.
constexpr int terms(int degree) { return (degree + 1) * (degree + 2) / 2; }
constexpr int max_degree = 4;

/// Points of up to four neighborhoods, each in a frame of its own. Point i of neighborhood `lane` is at
/// [i * lanes + lane]; where a neighborhood has fewer points than others, they are 0 and have no weight.
struct Heights {
    static constexpr std::size_t lanes = 4;
    std::vector<double> x, y, z, weight;
    std::array<std::size_t, lanes> counts{};

    /// Makes all neighborhoods empty.
    void clear();
    /// Makes room for the points of an empty neighborhood.
    void add(std::size_t lane, std::size_t count);
};

/// Planes through the first points of neighborhoods.
struct Planes {
    static constexpr std::size_t lanes = Heights::lanes;
    double axes[3][3][lanes] = {};             ///< of axis, coordinate and lane: unit vectors, the normal the last
    std::array<std::size_t, lanes> nearest{};  ///< how many points after the first are its direct neighbors
    std::array<double, lanes> scale{}, edge_length{};  ///< mean distance from the first point; that of its neighbors
};

/// From x, y, z of points as they are offset from the first of each neighborhood to coordinates and heights over its
/// plane, in units of the mean distance, and weights: equal ones if `even`, which noisy surfaces need; else near points
/// weigh more, which makes fits accurate on clean ones. Fills scale and edge_length of `planes`; a neighborhood of no
/// extent has a scale of 0, and no points afterwards. `wide`: as below.
void put_on_planes(Heights& points, Planes& planes, bool even, bool wide);

/// z = sum of a x^i y^j, ordered by i + j, then by j; coefficients above the degree are zero, as are all if it is 0.
struct Polynomial {
    std::array<double, terms(max_degree)> a{};
    int degree = 0;
};

using Polynomials = std::array<Polynomial, Heights::lanes>;

double height_of(const Polynomial& found, double x, double y);

/// Of each neighborhood the polynomial of the highest degree, 2 to `degree`, that its points determine; else of degree
/// 0. It depends on that neighborhood alone. `wide`: uses registers of four numbers, which the processor must have
/// (`has_wide_registers`); bits are the same.
Polynomials fit_heights(int degree, const Heights& heights, bool wide);

/// Whether the processor and the operating system have registers of four doubles (AVX2).
bool has_wide_registers();

}  // namespace fovea::field
