// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/height_fits.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#ifdef __x86_64__
#include <cpuid.h>
#endif

namespace fovea::field {
namespace {

/// A number of each neighborhood. Compilers make two registers of it where processors have none of this size, or are
/// not known to; each number is rounded by itself, so that results are the same.
using Lanes = double __attribute__((vector_size(Heights::lanes * sizeof(double))));
/// Of a comparison: all bits of a lane are set where it holds.
using Held = std::int64_t __attribute__((vector_size(Heights::lanes * sizeof(double))));

/// Pivot, as a share of its diagonal entry, at or below which a coefficient counts as undetermined.
constexpr double least_pivot = 1e-10;
constexpr std::size_t unrolled = 2;  // points that are added up together
constexpr int max_size = terms(max_degree), moment_count = terms(2 * max_degree);

// What is below is compiled for more than one kind of registers, so that all of it is part of its caller; vectors are
// handed over by their addresses, as calls differ between these kinds.
#define FOVEA_PART_OF_CALLER [[gnu::always_inline]] inline

FOVEA_PART_OF_CALLER void load(const std::vector<double>& values, std::size_t i, Lanes* lanes) {
    std::memcpy(lanes, values.data() + i * Heights::lanes, sizeof(Lanes));
}

FOVEA_PART_OF_CALLER void store(const Lanes* lanes, std::vector<double>& values, std::size_t i) {
    std::memcpy(values.data() + i * Heights::lanes, lanes, sizeof(Lanes));
}

/// put_on_planes.
FOVEA_PART_OF_CALLER void turn(Heights& points, Planes& planes, bool even) {
    const std::size_t rows = points.x.size() / Heights::lanes;
    Lanes count, nearest, axes[3][3], sum{}, edge{};
    for (std::size_t lane = 0; lane < Heights::lanes; ++lane) {
        count[lane] = double(points.counts[lane]);
        nearest[lane] = double(planes.nearest[lane]);
    }
    std::memcpy(axes, planes.axes, sizeof(axes));
    Lanes x, y, z;
    const auto load_row = [&](std::size_t i) __attribute__((always_inline)) {
        load(points.x, i, &x);
        load(points.y, i, &y);
        load(points.z, i, &z);
    };
    for (std::size_t i = 1; i < rows; ++i) {
        load_row(i);
        Lanes length = x * x + y * y + z * z;
        for (std::size_t lane = 0; lane < Heights::lanes; ++lane) length[lane] = std::sqrt(length[lane]);
        sum += length;
        edge = nearest == double(i) ? sum / double(i) : edge;
    }
    const Lanes others = count - 1.0, scale = others > 0.0 ? sum / others : Lanes{};
    const Lanes inverse = scale > 0.0 ? 1.0 / scale : Lanes{};
    for (std::size_t i = 0; i < rows; ++i) {
        load_row(i);
        Lanes at[3];
        for (int k = 0; k < 3; ++k) at[k] = (x * axes[k][0] + y * axes[k][1] + z * axes[k][2]) * inverse;
        Lanes weight = 1.0 / (0.1 + at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
        if (even) weight = Lanes{} + 1.0;
        weight = count > double(i) ? weight : Lanes{};
        store(&at[0], points.x, i);
        store(&at[1], points.y, i);
        store(&at[2], points.z, i);
        store(&weight, points.weight, i);
    }
    for (std::size_t lane = 0; lane < Heights::lanes; ++lane) {
        planes.scale[lane] = scale[lane];
        planes.edge_length[lane] = edge[lane];
        if (!(scale[lane] > 0.0)) points.counts[lane] = 0;
    }
}

/// Monomials x^i y^j up to a degree, ordered as in Polynomial, all multiplied by m[0].
template <int degree, typename Number>
FOVEA_PART_OF_CALLER void monomials(const Number* x, const Number* y, Number* m) {
    for (int d = 1; d <= degree; ++d) {
        const Number* lower = m + terms(d - 2);
        Number* own = m + terms(d - 1);
        for (int j = 0; j < d; ++j) own[j] = *x * lower[j];
        own[d] = *y * lower[d - 1];
    }
}

/// Weighted sums of all monomials up to twice the highest degree (moments), and of z times monomials up to the highest;
/// those of lower degrees come first.
FOVEA_PART_OF_CALLER void add_up(const Heights& points, Lanes* moments, Lanes* heights) {
    Lanes x[unrolled], y[unrolled], z[unrolled], m[unrolled][moment_count];
    std::fill_n(moments, moment_count, Lanes{});
    std::fill_n(heights, max_size, Lanes{});
    const std::size_t rows = points.x.size() / Heights::lanes;
    for (std::size_t i = 0; i < rows; i += unrolled) {
        for (std::size_t k = 0; k < unrolled; ++k) {
            load(points.x, i + k, &x[k]);
            load(points.y, i + k, &y[k]);
            load(points.z, i + k, &z[k]);
            load(points.weight, i + k, &m[k][0]);
            monomials<2 * max_degree>(&x[k], &y[k], m[k]);
        }
        for (int k = 0; k < moment_count; ++k) moments[k] += m[0][k] + m[1][k];
        for (int k = 0; k < max_size; ++k) heights[k] += z[0] * m[0][k] + z[1] * m[1][k];
    }
}

/// Turns sums of z into coefficients `a`, by L D L^T factorization of the normal matrix, a column at a time; its
/// entries are moments, of which only terms(2 degree) are distinct. `held`: where they are determined, else they mean
/// nothing.
FOVEA_PART_OF_CALLER void solve(int degree, const Lanes* moments, Lanes* a, Held* held) {
    const int size = terms(degree);
    Lanes l[max_size][max_size], scaled[max_size], diagonal[max_size], inverse[max_size];
    int row = 0;
    for (int d = 0; d <= degree; ++d)
        for (int j = 0; j <= d; ++j, ++row) {
            int column = 0;
            for (int e = 0; e <= d && column <= row; ++e)
                for (int k = 0; k <= e && column <= row; ++k, ++column)
                    l[row][column] = moments[terms(d + e - 1) + j + k];
            diagonal[row] = l[row][row];
        }
    *held = ~Held{};
    for (int c = 0; c < size; ++c) {
        *held &= l[c][c] > least_pivot * diagonal[c];
        inverse[c] = 1.0 / l[c][c];
        for (int r = c + 1; r < size; ++r) scaled[r] = l[r][c] * inverse[c];
        for (int r = c + 1; r < size; ++r) {
            for (int k = c + 1; k <= r; ++k) l[r][k] -= l[r][c] * scaled[k];
            l[r][c] = scaled[r];
        }
    }
    for (int c = 0; c < size; ++c)
        for (int r = c + 1; r < size; ++r) a[r] -= l[r][c] * a[c];
    for (int r = size - 1; r >= 0; --r) {
        a[r] *= inverse[r];
        for (int k = r + 1; k < size; ++k) a[r] -= l[k][r] * a[k];
    }
}

FOVEA_PART_OF_CALLER void fit(int degree, const Heights& points, Polynomials* found) {
    Lanes moments[moment_count], heights[max_size];
    add_up(points, moments, heights);
    for (bool remain = true; remain && degree >= 2; --degree) {
        Lanes a[max_size];
        Held held;
        std::copy_n(heights, terms(degree), a);
        solve(degree, moments, a, &held);
        remain = false;
        for (std::size_t lane = 0; lane < Heights::lanes; ++lane) {
            Polynomial& one = (*found)[lane];
            if (one.degree || points.counts[lane] < std::size_t(terms(2))) continue;
            if (held[lane] && points.counts[lane] >= std::size_t(terms(degree))) {
                for (int k = 0; k < terms(degree); ++k) one.a[k] = a[k][lane];
                one.degree = degree;
            } else {
                remain = true;
            }
        }
    }
}

void fit_narrow(int degree, const Heights& points, Polynomials* found) { fit(degree, points, found); }
void turn_narrow(Heights& points, Planes& planes, bool even) { turn(points, planes, even); }

#ifdef __x86_64__
[[gnu::target("avx2")]] void turn_wide(Heights& points, Planes& planes, bool even) { turn(points, planes, even); }

[[gnu::target("avx2")]] void fit_wide(int degree, const Heights& points, Polynomials* found) {
    fit(degree, points, found);
}

bool find_wide_registers() {
    unsigned a, b, c, d, low, high;
    if (!__get_cpuid(1, &a, &b, &c, &d) || !(c & bit_OSXSAVE)) return false;
    __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    constexpr unsigned kept = 6;  // registers of 16 bytes and of 32, by the operating system
    return (low & kept) == kept && __get_cpuid_count(7, 0, &a, &b, &c, &d) && (b & bit_AVX2);
}
#else
void fit_wide(int degree, const Heights& points, Polynomials* found) { fit(degree, points, found); }
void turn_wide(Heights& points, Planes& planes, bool even) { turn(points, planes, even); }
bool find_wide_registers() { return false; }
#endif

}  // namespace

void Heights::clear() {
    for (auto* values : {&x, &y, &z, &weight}) values->clear();
    counts = {};
}

void Heights::add(std::size_t lane, std::size_t count) {
    counts[lane] = count;
    const std::size_t rows = (count + unrolled - 1) / unrolled * unrolled;
    if (rows * lanes <= x.size()) return;
    for (auto* values : {&x, &y, &z, &weight}) values->resize(rows * lanes, 0.0);
}

void put_on_planes(Heights& points, Planes& planes, bool even, bool wide) {
    (wide ? turn_wide : turn_narrow)(points, planes, even);
}

double height_of(const Polynomial& found, double x, double y) {
    double m[terms(max_degree)] = {1.0}, height = 0.0;
    monomials<max_degree>(&x, &y, m);
    for (int k = 0; k < terms(max_degree); ++k) height += found.a[k] * m[k];
    return height;
}

Polynomials fit_heights(int degree, const Heights& heights, bool wide) {
    Polynomials found;
    (wide ? fit_wide : fit_narrow)(degree, heights, &found);
    return found;
}

bool has_wide_registers() {
    static const bool found = find_wide_registers();
    return found;
}

}  // namespace fovea::field
