// SPDX-License-Identifier: GPL-3.0-or-later
// Zero sets and crests of fields over the vertices of a surface, as segments in triangles.
#pragma once

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/line/curves.h>
#include <fovea/mesh/triangle_sides.h>

namespace fovea::line {

/// Zero crossing on a side of a triangle, between the side's vertices a and b (in the order of TriangleSides).
struct ZeroCrossing {
    Index side;
    Index a, b;
    float t;  ///< 0 at a, 1 at b
    template <typename Value>
    auto mix(const Value& value) const {
        return value(a) + t * (value(b) - value(a));
    }
};

// Templates below are static: the compiler inlines what is called once only where nothing else can call it.

/// Calls emit(triangle, out) for all triangles in parallel; the pieces are in the order of the triangles.
template <typename Emit>
static Curves collect_pieces(std::size_t triangles, const Emit& emit) {
    return parallel_collect<CurvePiece>(triangles, 16384, [&](std::size_t begin, std::size_t end, auto& out) {
        for (std::size_t t = begin; t < end; ++t) emit(static_cast<Index>(t), out);
    });
}

/// Margins: quantities that must be positive on a line. Either one, or two, each of which clips the line on its own and
/// of which the first determines strength.
inline vec2 margins(float one) { return {one, 1.0f}; }
inline vec2 margins(const vec2& two) { return two; }

/// Clips the segment between two crossings to where its margins, interpolated linearly between the crossings, are
/// positive, and appends it. strength(margin) is evaluated at the ends of the clipped segment.
template <typename Position, typename Margin, typename Strength>
static void append_trimmed(const Position& position, Index triangle, const ZeroCrossing (&ends)[2],
                           const Margin& margin, const Strength& strength, Array<CurvePiece>& out) {
    const vec2 above[2] = {margins(ends[0].mix(margin)), margins(ends[1].mix(margin))};
    float from = 0.0f, to = 1.0f;  // fractions from end 0 to end 1
    for (int c = 0; c < 2; ++c) {
        const float a = above[0][c], b = above[1][c];
        if (!(a > 0.0f) && !(b > 0.0f)) return;
        if (!(a > 0.0f)) from = std::max(a / (a - b), from);
        if (!(b > 0.0f)) to = std::min(a / (a - b), to);
    }
    if (!(from < to)) return;  // also if NaN
    CurvePiece piece{triangle, {ends[0].side, ends[1].side}, {}, {}, 0};
    const vec3 first = ends[0].mix(position), last = ends[1].mix(position);
    const auto put = [&](int k, float t, bool cut) {
        piece.point[k] = cut ? first + t * (last - first) : k == 0 ? first : last;
        piece.strength[k] = strength(cut ? above[0].x + t * (above[1].x - above[0].x) : above[k].x);
        if (cut) piece.side[k] = none;
    };
    put(0, from, from > 0.0f);
    put(1, to, to < 1.0f);
    // Fields may overflow on a broken or enormous mesh.
    const vec3 sum = piece.point[0] + piece.point[1];
    if (std::isfinite(sum.x + sum.y + sum.z) && std::isfinite(piece.strength[0] + piece.strength[1]))
        out.push_back(piece);
}

inline auto positions_of(const Surface& surface) {
    return [&surface](Index v) { return surface.positions[v]; };
}

/// Appends the segment of the zero set of `value` in one triangle, if there is one.
template <typename Value, typename Margin, typename Strength>
static void append_zero(const Surface& surface, const TriangleSides& sides, Index triangle, const Value& value,
                        const Margin& margin, const Strength& strength, Array<CurvePiece>& out) {
    const Triangle& t = surface.triangles[triangle];
    const float f[3] = {value(t.x), value(t.y), value(t.z)};
    const bool positive[3] = {f[0] >= 0.0f, f[1] >= 0.0f, f[2] >= 0.0f};
    if (positive[0] == positive[1] && positive[1] == positive[2]) return;
    if (!std::isfinite(f[0] + f[1] + f[2])) return;
    const int alone = positive[0] == positive[1] ? 2 : positive[0] == positive[2] ? 1 : 0;
    const glm::uvec3& of = sides.of_triangle[triangle];
    // By linear interpolation between the side's ends, in their order: independent of the triangle it is visited from.
    const auto cross = [&](Index side) -> ZeroCrossing {
        const Edge e = sides.vertices[side];
        const float a = value(e.x), t = a / (a - value(e.y));
        return {side, e.x, e.y, t >= 0.0f && t <= 1.0f ? t : 0.5f};
    };
    const ZeroCrossing ends[2] = {cross(of[alone]), cross(of[(alone + 2) % 3])};
    append_trimmed(positions_of(surface), triangle, ends, margin, strength, out);
}

/// Curves where `value` (per vertex) is zero and `margin` (per vertex; see margins) is positive. Zero counts as
/// positive, so that each side is crossed in both of its triangles or in neither (simulation of simplicity). Triangles
/// with a NaN have no crossing.
template <typename Value, typename Margin, typename Strength>
static Curves trace_zero_set(const Surface& surface, const Value& value, const Margin& margin,
                             const Strength& strength) {
    const auto sides = triangle_sides(surface);
    return collect_pieces(surface.triangles.size(), [&](Index triangle, Array<CurvePiece>& out) {
        append_zero(surface, *sides, triangle, value, margin, strength, out);
    });
}

/// Conservative bounds of a field's values. Infinite or NaN bounds mean unbounded: every query must treat them as "may
/// contain".
struct Range {
    float low, high;
    /// False only if x is certainly outside.
    bool may_hold(float x) const { return !(x < low) && !(x > high); }
};

/// Evenly spaced levels: first + step, first + 2 step, ..., first + count step.
struct Levels {
    float first, step;
    int count;
    float operator[](int i) const { return first + float(i) * step; }
    /// Number of levels <= value; 0 for NaN.
    int below(float value) const {
        const float share = (value - first) / step;
        int i = share > 0.0f ? static_cast<int>(std::min(share, float(count))) : 0;
        while (i < count && operator[](i + 1) <= value) ++i;  // rounding may be off by one
        while (i > 0 && !(operator[](i) <= value)) --i;
        return i;
    }
    /// True only if certainly no level is in the range.
    bool none_in(const Range& range) const {
        const float from = (range.low - first) / step, to = (range.high - first) / step;
        // Covers the rounding errors of the two divisions.
        const float margin = 1e-5f * (std::abs(from) + std::abs(to)) + 1e-3f;
        return to + margin < 1.0f || from - margin > float(count) || std::floor(to + margin) < std::ceil(from - margin);
    }
};

/// Appends a segment for each level of `value` that crosses a triangle.
template <typename Value>
static void append_levels(const Surface& surface, const TriangleSides& sides, Index triangle, const Value& value,
                          const Levels& levels, Array<CurvePiece>& out) {
    const Triangle& t = surface.triangles[triangle];
    const auto below = [&](Index v) { return levels.below(value(v)); };
    const auto [low, high] = std::minmax({below(t.x), below(t.y), below(t.z)});
    const auto always = [](auto) { return 1.0f; };
    for (int i = low + 1; i <= high; ++i) {
        const std::size_t before = out.size();
        append_zero(surface, sides, triangle, [&](Index v) { return value(v) - levels[i]; }, always, always, out);
        if (out.size() > before) out.back().level = static_cast<Index>(i);
    }
}

/// Negated second derivative, across a crest, of a quantity with gradients `uphill` at a triangle's corners `p`, where
/// the gradient at corner `alone` opposes the other two: minus the derivative of signed gradient length along the mean
/// gradient direction. Positive if the quantity has a maximum between the corners.
inline double bend_across(const dvec3 (&p)[3], const dvec3 (&uphill)[3], int alone) {
    const dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    dvec3 gradient(0.0), direction(0.0);
    for (int i = 0; i < 3; ++i) {
        const double length = glm::length(uphill[i]), sign = i == alone ? -1.0 : 1.0;
        gradient += sign * length * glm::cross(normal, p[(i + 2) % 3] - p[(i + 1) % 3]);
        if (length > 0.0) direction += sign / length * uphill[i];
    }
    return -glm::dot(gradient, direction) / (glm::dot(normal, normal) * glm::length(direction));
}

/// Appends the segment of a crest in one triangle; see trace_maxima.
template <typename Uphill, typename Margin, typename Strength>
static void append_maximum(const Surface& surface, const TriangleSides& sides, Index triangle, const Uphill& uphill,
                           float least_bend, const Margin& margin, const Strength& strength, Array<CurvePiece>& out) {
    const Triangle& corners = surface.triangles[triangle];
    const vec3 climb[3] = {uphill(corners.x), uphill(corners.y), uphill(corners.z)};
    ZeroCrossing ends[2];
    int count = 0, alone = 0;
    for (int i = 0; i < 3; ++i) {
        if (!(glm::dot(climb[i], climb[(i + 1) % 3]) <= 0.0f)) {
            alone = (i + 2) % 3;
            continue;
        }
        // Three crossings: the directions are inconsistent in this triangle (an umbilic, or noise).
        if (count == 2) return;
        const Index side = sides.of_triangle[triangle][i];
        const Edge e = sides.vertices[side];
        const float a = glm::length(uphill(e.x)), b = glm::length(uphill(e.y));
        ends[count++] = {side, e.x, e.y, a / (a + b)};
    }
    if (count != 2) return;
    const auto position = [&](Index v) { return dvec3(surface.positions[v]); };
    const double bend = bend_across({position(corners.x), position(corners.y), position(corners.z)},
                                    {dvec3(climb[0]), dvec3(climb[1]), dvec3(climb[2])}, alone);
    if (!(bend > 0.0) || bend < least_bend) return;
    append_trimmed(positions_of(surface), triangle, ends, margin, strength, out);
}

/// Crests: curves along which a quantity has a maximum across them. `uphill(v)`: vector at each vertex along which the
/// quantity increases, with the length of its derivative; unaffected by the sign of the direction, as the derivative
/// changes sign with it. A side is crossed if the vectors at its ends oppose each other. Only crossings at a maximum,
/// whose (negated) second derivative across the curve is at least `least_bend`, in triangles that are `wanted`.
/// `margin` and `strength` as above. Ohtake, Belyaev & Seidel, "Ridge-Valley Lines on Meshes via Implicit Surface
/// Fitting", SIGGRAPH 2004, section 4.
template <typename Wanted, typename Uphill, typename Margin, typename Strength>
static Curves trace_maxima(const Surface& surface, const Wanted& wanted, const Uphill& uphill, float least_bend,
                           const Margin& margin, const Strength& strength) {
    const auto sides = triangle_sides(surface);
    return collect_pieces(surface.triangles.size(), [&](Index triangle, Array<CurvePiece>& out) {
        if (wanted(triangle)) append_maximum(surface, *sides, triangle, uphill, least_bend, margin, strength, out);
    });
}

}  // namespace fovea::line
