// SPDX-License-Identifier: GPL-3.0-or-later
// Zero sets of fields over the vertices of a surface, as pieces of curves in triangles.
#pragma once

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/line/curves.h>
#include <fovea/mesh/triangle_sides.h>

namespace fovea::line {

/// A zero crossing on a side of a triangle, from vertex a to vertex b of the side as it is numbered.
struct ZeroCrossing {
    Index side;
    Index a, b;
    float t;  ///< 0 at a, 1 at b
    template <typename Value>
    auto mix(const Value& value) const {
        return value(a) + t * (value(b) - value(a));
    }
};

/// Between a and b, from values there of unlike sign (zero counts as positive). The same from either side of an edge.
inline ZeroCrossing crossing(const TriangleSides& sides, Index side, float at_a, float at_b) {
    const Edge e = sides.vertices[side];
    const float t = at_a / (at_a - at_b);
    return {side, e.x, e.y, t >= 0.0f && t <= 1.0f ? t : 0.5f};
}

/// Runs emit(triangle, out) over all triangles in parallel; pieces stand in the order of the triangles.
template <typename Emit>
Curves collect_pieces(std::size_t triangles, const Emit& emit) {
    return parallel_collect<CurvePiece>(triangles, 16384, [&](std::size_t begin, std::size_t end, auto& out) {
        for (std::size_t t = begin; t < end; ++t) emit(static_cast<Index>(t), out);
    });
}

/// How far what has to be positive is above zero: one number, or two that cut each for itself, of which the first gives
/// the strength.
inline vec2 margins(float one) { return {one, 1.0f}; }
inline vec2 margins(const vec2& two) { return two; }

/// Appends the part of a piece between two crossings where the margins, linear between their values at the two, are
/// positive. strength(margin) is asked at both ends of what is left.
template <typename Position, typename Margin, typename Strength>
void append_trimmed(const Position& position, Index triangle, const ZeroCrossing (&ends)[2], const Margin& margin,
                    const Strength& strength, std::vector<CurvePiece>& out) {
    const vec2 above[2] = {margins(ends[0].mix(margin)), margins(ends[1].mix(margin))};
    float from = 0.0f, to = 1.0f;  // of the way from end 0 to end 1
    for (int c = 0; c < 2; ++c) {
        const float a = above[0][c], b = above[1][c];
        if (!(a > 0.0f) && !(b > 0.0f)) return;
        if (!(a > 0.0f)) from = std::max(a / (a - b), from);
        if (!(b > 0.0f)) to = std::min(a / (a - b), to);
    }
    if (!(from < to)) return;  // NaN, too
    CurvePiece piece{triangle, {ends[0].side, ends[1].side}, {}, {}, 0};
    const vec3 first = ends[0].mix(position), last = ends[1].mix(position);
    const auto put = [&](int k, float t, bool cut) {
        piece.point[k] = cut ? first + t * (last - first) : k == 0 ? first : last;
        piece.strength[k] = strength(cut ? above[0].x + t * (above[1].x - above[0].x) : above[k].x);
        if (cut) piece.side[k] = none;
    };
    put(0, from, from > 0.0f);
    put(1, to, to < 1.0f);
    // On a broken or enormous mesh a field may be beyond all numbers.
    const vec3 sum = piece.point[0] + piece.point[1];
    if (std::isfinite(sum.x + sum.y + sum.z) && std::isfinite(piece.strength[0] + piece.strength[1]))
        out.push_back(piece);
}

inline auto positions_of(const Surface& surface) {
    return [&surface](Index v) { return surface.positions[v]; };
}

/// Appends the piece of the zero set of `value` in one triangle, where there is one.
template <typename Value, typename Margin, typename Strength>
void append_zero(const Surface& surface, const TriangleSides& sides, Index triangle, const Value& value,
                 const Margin& margin, const Strength& strength, std::vector<CurvePiece>& out) {
    const Triangle& t = surface.triangles[triangle];
    const float f[3] = {value(t.x), value(t.y), value(t.z)};
    const bool positive[3] = {f[0] >= 0.0f, f[1] >= 0.0f, f[2] >= 0.0f};
    if (positive[0] == positive[1] && positive[1] == positive[2]) return;
    if (!std::isfinite(f[0] + f[1] + f[2])) return;
    const int alone = positive[0] == positive[1] ? 2 : positive[0] == positive[2] ? 1 : 0;
    const glm::uvec3& of = sides.of_triangle[triangle];
    const auto cross = [&](Index side) {
        const Edge e = sides.vertices[side];
        return crossing(sides, side, value(e.x), value(e.y));
    };
    const ZeroCrossing ends[2] = {cross(of[alone]), cross(of[(alone + 2) % 3])};
    append_trimmed(positions_of(surface), triangle, ends, margin, strength, out);
}

/// Curves where `value` (per vertex) is zero and `margin` (per vertex; see margins) positive. Zero counts as positive,
/// so that each side is crossed by both of its triangles or by neither (simulation of simplicity). NaN crosses nothing.
template <typename Value, typename Margin, typename Strength>
Curves trace_zero_set(const Surface& surface, const Value& value, const Margin& margin, const Strength& strength) {
    const auto sides = triangle_sides(surface);
    return collect_pieces(surface.triangles.size(), [&](Index triangle, std::vector<CurvePiece>& out) {
        append_zero(surface, *sides, triangle, value, margin, strength, out);
    });
}

/// Conservative bounds of a field's values. Infinite or NaN bounds mean unbounded: every query must treat them as "may
/// contain".
struct Range {
    float low, high;
    /// False only where it is certain.
    bool may_hold(float x) const { return !(x < low) && !(x > high); }
};

/// Values first + step, first + 2 step, ..., first + count step.
struct Levels {
    float first, step;
    int count;
    float operator[](int i) const { return first + float(i) * step; }
    /// How many levels are not above a value; 0 for NaN.
    int below(float value) const {
        const float share = (value - first) / step;
        int i = share > 0.0f ? static_cast<int>(std::min(share, float(count))) : 0;
        while (i < count && operator[](i + 1) <= value) ++i;  // arithmetic may be off by one
        while (i > 0 && !(operator[](i) <= value)) --i;
        return i;
    }
    /// True only where it is certain that no level lies in the range.
    bool none_in(const Range& range) const {
        const float from = (range.low - first) / step, to = (range.high - first) / step;
        // Arithmetic may move a number by less than the share of a step that is left out here.
        const float margin = 1e-5f * (std::abs(from) + std::abs(to)) + 1e-3f;
        return to + margin < 1.0f || from - margin > float(count) || std::floor(to + margin) < std::ceil(from - margin);
    }
};

/// Appends a piece for each level of `value` in one triangle.
template <typename Value>
void append_levels(const Surface& surface, const TriangleSides& sides, Index triangle, const Value& value,
                   const Levels& levels, std::vector<CurvePiece>& out) {
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

/// How fast the lengths of vectors fall along their own direction in a triangle, where that of corner `alone` points
/// against the two others: the second derivative, turned around, of the quantity that they are derivatives of. Positive
/// where it has a maximum between them.
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

/// Appends the piece in one triangle of a curve along which a quantity is greatest across it; see trace_maxima.
template <typename Uphill, typename Margin, typename Strength>
void append_maximum(const Surface& surface, const TriangleSides& sides, Index triangle, const Uphill& uphill,
                    float least_bend, const Margin& margin, const Strength& strength, std::vector<CurvePiece>& out) {
    const Triangle& corners = surface.triangles[triangle];
    const vec3 climb[3] = {uphill(corners.x), uphill(corners.y), uphill(corners.z)};
    ZeroCrossing ends[2];
    int count = 0, alone = 0;
    for (int i = 0; i < 3; ++i) {
        if (!(glm::dot(climb[i], climb[(i + 1) % 3]) <= 0.0f)) {
            alone = (i + 2) % 3;
            continue;
        }
        // Three crossings: the directions do not agree in this triangle, near an umbilic or in noise.
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

/// Curves along which a quantity is greatest across them. `uphill(v)`: a vector at each vertex along which the quantity
/// grows, of the length of its derivative; its line matters, not the way it was turned (the derivative turns around
/// with the direction). A side is crossed where its two vectors point against each other. Only where the quantity has a
/// maximum, and its second derivative across the curve is at least `least_bend`, in triangles that are `wanted`.
/// `margin` and `strength` as above. Ohtake, Belyaev & Seidel, "Ridge-Valley Lines on Meshes via Implicit Surface
/// Fitting", SIGGRAPH 2004, 4.
template <typename Wanted, typename Uphill, typename Margin, typename Strength>
Curves trace_maxima(const Surface& surface, const Wanted& wanted, const Uphill& uphill, float least_bend,
                    const Margin& margin, const Strength& strength) {
    const auto sides = triangle_sides(surface);
    return collect_pieces(surface.triangles.size(), [&](Index triangle, std::vector<CurvePiece>& out) {
        if (wanted(triangle)) append_maximum(surface, *sides, triangle, uphill, least_bend, margin, strength, out);
    });
}

}  // namespace fovea::line
