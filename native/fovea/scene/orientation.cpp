// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/orientation.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace fovea::scene {
namespace {

using Wide = __int128;

/// Row of the determinant in homogeneous coordinates: weight w is 1 for a point, 0 for a direction of displacement.
struct Row {
    std::int64_t x, y, z, w;
};

Row row_of(const dvec3& p) {
    return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y), static_cast<std::int64_t>(p.z), 1};
}

Row along(int axis) { return {axis == 0, axis == 1, axis == 2, 0}; }

Wide minor(const Row& a, const Row& b, const Row& c) {
    const auto twice = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
        return Wide(p) * s - Wide(q) * r;
    };
    return a.x * twice(b.y, b.z, c.y, c.z) - a.y * twice(b.x, b.z, c.x, c.z) + a.z * twice(b.x, b.y, c.x, c.y);
}

/// Determinant of the rows (x, y, z, w).
Wide determinant(const Row (&r)[4]) {
    return -r[0].w * minor(r[1], r[2], r[3]) + r[1].w * minor(r[0], r[2], r[3]) - r[2].w * minor(r[0], r[1], r[3]) +
           r[3].w * minor(r[0], r[1], r[2]);
}

/// Of four points, their differences from the last one.
struct Offsets {
    Row a, b, c;

    explicit Offsets(const dvec3 (&p)[4]) : a(row_of(p[0] - p[3])), b(row_of(p[1] - p[3])), c(row_of(p[2] - p[3])) {}

    /// determinant() of the points.
    Wide volume() const { return minor(a, b, c); }
};

int sign_of(Wide value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Sign of the volume after translating the second surface: that of its derivative along the first axis along which it
/// changes, (s_a b x c + s_b c x a + s_c a x b) where s is how the offset moves.
int shifted_sign(const Offsets& of, unsigned second) {
    const auto moves = [&](int i) { return int(second >> i & 1) - int(second >> 3 & 1); };
    using Axis = std::int64_t Row::*;
    constexpr Axis axes[] = {&Row::x, &Row::y, &Row::z};
    for (int axis = 0; axis < 3; ++axis) {
        const Axis y = axes[(axis + 1) % 3], z = axes[(axis + 2) % 3];
        const auto cross = [&](const Row& p, const Row& q) { return Wide(p.*y) * (q.*z) - Wide(p.*z) * (q.*y); };
        const Wide change = moves(0) * cross(of.b, of.c) + moves(1) * cross(of.c, of.a) + moves(2) * cross(of.a, of.b);
        if (const int sign = sign_of(change)) return sign;
    }
    return 0;
}

/// Coordinate j of the point of rank i is perturbed by e^(2^(3 i + j)). The determinant is then a polynomial in e,
/// whose terms are sets of (point, coordinate), ascending in the number that their bits form; the first nonzero term
/// decides.
int simulated_sign(const dvec3 (&p)[4]) {
    const Row rows[4] = {row_of(p[0]), row_of(p[1]), row_of(p[2]), row_of(p[3])};
    int rank[4] = {0, 1, 2, 3};
    std::sort(rank, rank + 4, [&](int a, int b) { return before(p[a], p[b]); });
    for (int i = 0; i < 3; ++i)
        if (p[rank[i]] == p[rank[i + 1]]) return 0;
    for (unsigned set = 1; set < 1u << 12; ++set) {
        Row moved[4] = {rows[0], rows[1], rows[2], rows[3]};
        unsigned axes = 0;
        bool once = true;  // at most one coordinate per point, and one point per coordinate
        for (int i = 0; i < 4 && once; ++i) {
            const unsigned of_point = set >> (3 * i) & 7u;
            if (of_point == 0) continue;
            once = std::has_single_bit(of_point) && !(axes & of_point);
            axes |= of_point;
            moved[rank[i]] = along(std::countr_zero(of_point));
        }
        if (!once) continue;
        if (const int sign = sign_of(determinant(moved))) return sign;
    }
    return 0;
}

}  // namespace

Orientation orientation(const dvec3 (&p)[4], unsigned second) {
    const dvec3 a = p[0] - p[3], b = p[1] - p[3], c = p[2] - p[3];  // exact: differences of at most 2^40
    const double yz = b.y * c.z, zy = b.z * c.y, zx = b.z * c.x, xz = b.x * c.z, xy = b.x * c.y, yx = b.y * c.x;
    const double value = a.x * (yz - zy) + a.y * (zx - xz) + a.z * (xy - yx);
    const double size = std::abs(a.x) * (std::abs(yz) + std::abs(zy)) + std::abs(a.y) * (std::abs(zx) + std::abs(xz)) +
                        std::abs(a.z) * (std::abs(xy) + std::abs(yx));
    if (std::abs(value) > orientation_error * size) return {value, value > 0.0 ? 1 : -1};
    const Offsets offsets(p);
    const Wide exact = offsets.volume();
    if (const int sign = sign_of(exact)) return {static_cast<double>(exact), sign};
    const bool both = second != 0 && second != 15;
    return {0.0, both ? shifted_sign(offsets, second) : simulated_sign(p)};
}

}  // namespace fovea::scene
