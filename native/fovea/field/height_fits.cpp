// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/height_fits.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

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
constexpr std::size_t unrolled = 2;       // points that are added up together
constexpr std::size_t rows_at_once = 32;  // points whose monomials are kept
constexpr int tile = 4;                   // entries of a column that are reduced together, in registers
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

/// Which monomial x^i y^j is, as ordered in Polynomial.
constexpr int place(int i, int j) { return terms(i + j - 1) + j; }

constexpr int whole_tiles(int size) { return (size + tile - 1) / tile * tile; }

/// Which moment an entry of the normal matrix is, by column and row; some moment where a tile goes beyond the rows.
constexpr auto entries = [] {
    std::array<std::array<std::uint8_t, whole_tiles(max_size)>, max_size> found{};
    const auto each = [](auto&& visit) {
        for (int d = 0; d <= max_degree; ++d)
            for (int j = 0; j <= d; ++j) visit(d - j, j);
    };
    each([&](int x, int y) {
        each([&](int i, int j) { found[place(x, y)][place(i, j)] = static_cast<std::uint8_t>(place(x + i, y + j)); });
    });
    return found;
}();

/// Adds sums over rows of x^i y^j, i < count, times the weight, to `sums`; times z, too, if `with_z`. `column`: of each
/// row y^j times the weight.
template <int count, bool with_z>
FOVEA_PART_OF_CALLER void add_column(const Heights& points, std::size_t begin, std::size_t end, const Lanes* column,
                                     int j, Lanes* sums) {
    Lanes sum[count];
    for (int i = 0; i < count; ++i) sum[i] = sums[place(i, j)];
    for (std::size_t row = begin; row < end; row += unrolled) {
        Lanes x[unrolled], z[unrolled], m[unrolled];
        for (std::size_t k = 0; k < unrolled; ++k) {
            load(points.x, row + k, &x[k]);
            if (with_z) load(points.z, row + k, &z[k]);
            m[k] = column[row + k - begin];
        }
#pragma GCC unroll 16
        for (int i = 0; i < count; ++i) {
            sum[i] += with_z ? z[0] * m[0] + z[1] * m[1] : m[0] + m[1];
            for (std::size_t k = 0; k < unrolled; ++k) m[k] *= x[k];
        }
    }
    for (int i = 0; i < count; ++i) sums[place(i, j)] = sum[i];
}

/// Adds weighted sums of all monomials up to twice the degree (moments), and of z times monomials up to the degree.
template <int degree>
FOVEA_PART_OF_CALLER void add_up(const Heights& points, Lanes* moments, Lanes* heights) {
    Lanes column[rows_at_once];
    const std::size_t rows = points.x.size() / Heights::lanes;
    for (std::size_t begin = 0; begin < rows; begin += rows_at_once) {
        const std::size_t end = std::min(rows, begin + rows_at_once);
        for (std::size_t row = begin; row < end; ++row) load(points.weight, row, &column[row - begin]);
        const auto add = [&]<int j>() __attribute__((always_inline)) {
            add_column<2 * degree + 1 - j, false>(points, begin, end, column, j, moments);
            if constexpr (j <= degree) add_column<degree + 1 - j, true>(points, begin, end, column, j, heights);
            for (std::size_t row = begin; row < end; ++row) {
                Lanes y;
                load(points.y, row, &y);
                column[row - begin] *= y;
            }
        };
        [&]<int... j>(std::integer_sequence<int, j...>) __attribute__((always_inline)) {
            (add.template operator()<j>(), ...);
        }(std::make_integer_sequence<int, 2 * degree + 1>());
    }
}

/// Turns sums of z into coefficients `a`, by L D L^T factorization of the normal matrix, a column at a time; its
/// entries are moments. `held`: where they are determined, else they mean nothing.
template <int degree>
FOVEA_PART_OF_CALLER void solve(const Lanes* moments, Lanes* a, Held* held) {
    constexpr int size = terms(degree);
    constexpr int rows = whole_tiles(size);
    Lanes l[size][rows], scaled[size][size], inverse[size];  // [column][row]: times the pivot, and L
    *held = ~Held{};
    for (int c = 0; c < size; ++c) {
        for (int begin = c / tile * tile; begin < rows; begin += tile) {
            Lanes entry[tile];
            for (int r = 0; r < tile; ++r) entry[r] = moments[entries[c][begin + r]];
            for (int k = 0; k < c; ++k)
                for (int r = 0; r < tile; ++r) entry[r] -= l[k][begin + r] * scaled[k][c];
            std::copy_n(entry, tile, l[c] + begin);
        }
        *held &= l[c][c] > least_pivot * moments[entries[c][c]];
        inverse[c] = 1.0 / l[c][c];
        for (int r = c + 1; r < size; ++r) scaled[c][r] = l[c][r] * inverse[c];
        for (int r = c + 1; r < size; ++r) a[r] -= scaled[c][r] * a[c];
    }
    for (int c = 0; c < size; ++c) a[c] *= inverse[c];
    for (int r = size - 1; r > 0; --r)
        for (int c = 0; c < r; ++c) a[c] -= scaled[c][r] * a[r];
}

/// Takes the polynomials of a degree where neighborhoods have points for it, and none yet; whether some remain without.
template <int degree>
FOVEA_PART_OF_CALLER bool take(const Heights& points, const Lanes* moments, const Lanes* heights, Polynomials* found) {
    Lanes a[terms(degree)];
    Held held;
    std::copy_n(heights, terms(degree), a);
    solve<degree>(moments, a, &held);
    bool remain = false;
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
    return remain;
}

/// fit_heights.
FOVEA_PART_OF_CALLER void fit(int degree, const Heights& points, Polynomials* found) {
    Lanes moments[moment_count]{}, heights[max_size]{};
    degree >= 4 ? add_up<4>(points, moments, heights) : add_up<3>(points, moments, heights);
    if (degree >= 4 && !take<4>(points, moments, heights, found)) return;
    if (degree >= 3 && !take<3>(points, moments, heights, found)) return;
    take<2>(points, moments, heights, found);
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
    double column = 1.0, height = 0.0;
    for (int j = 0; j <= max_degree; ++j, column *= y) {
        double m = column;
        for (int i = 0; i + j <= max_degree; ++i, m *= x) height += found.a[place(i, j)] * m;
    }
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
