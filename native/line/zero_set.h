// Zero sets of fields over the vertices of a surface, as pieces of curves in triangles.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "line/curves.h"
#include "mesh/triangle_sides.h"

namespace fovea {

/// A zero crossing on a side of a triangle, from vertex a to vertex b of the side as it is numbered.
struct Crossing {
    Index side;
    Index a, b;
    float t;  ///< 0 at a, 1 at b
    template <typename Value>
    auto mix(const Value& value) const {
        return value(a) + t * (value(b) - value(a));
    }
};

/// Between a and b, from values there of unlike sign (zero counts as positive). The same from either side of an edge.
inline Crossing crossing(const TriangleSides& sides, Index side, float at_a, float at_b) {
    const Edge e = sides.vertices[side];
    const float t = at_a / (at_a - at_b);
    return {side, e.x, e.y, t >= 0.0f && t <= 1.0f ? t : 0.5f};
}

/// Runs emit(triangle, out) over all triangles in parallel; pieces stand in the order of the triangles.
template <typename Emit>
Curves collect_pieces(std::size_t triangles, const Emit& emit) {
    constexpr std::size_t block = 16384;
    std::vector<std::vector<CurvePiece>> parts((triangles + block - 1) / block);
    parallel_blocks(triangles, block, [&](std::size_t b, std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) emit(static_cast<Index>(t), parts[b]);
    });
    Curves curves;
    for (const auto& part : parts) curves.insert(curves.end(), part.begin(), part.end());
    return curves;
}

/// Appends the part of a piece between two crossings where `margin`, linear between its values at the two, is positive.
/// strength(margin) is asked at both ends of what is left.
template <typename Strength>
void append_trimmed(const Surface& surface, Index triangle, const Crossing (&ends)[2], const float (&margin)[2],
                    const Strength& strength, std::vector<CurvePiece>& out) {
    if (!(margin[0] > 0.0f) && !(margin[1] > 0.0f)) return;
    CurvePiece piece{triangle, {ends[0].side, ends[1].side}, {}, {}, 0};
    const auto position = [&](Index v) { return surface.positions[v]; };
    for (int k = 0; k < 2; ++k) {
        piece.point[k] = ends[k].mix(position);
        piece.strength[k] = strength(margin[k]);
    }
    for (int k = 0; k < 2; ++k) {
        if (margin[k] > 0.0f) continue;
        const float t = margin[k] / (margin[k] - margin[1 - k]);
        const vec3 whole = piece.point[1 - k] - piece.point[k];
        piece.point[k] += t * whole;
        piece.side[k] = none;
        piece.strength[k] = strength(0.0f);
    }
    // On a broken or enormous mesh a field may be beyond all numbers.
    const vec3 sum = piece.point[0] + piece.point[1];
    if (std::isfinite(sum.x + sum.y + sum.z) && std::isfinite(piece.strength[0] + piece.strength[1])) out.push_back(piece);
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
    const Crossing ends[2] = {cross(of[alone]), cross(of[(alone + 2) % 3])};
    append_trimmed(surface, triangle, ends, {ends[0].mix(margin), ends[1].mix(margin)}, strength, out);
}

/// Curves where `value` (per vertex) is zero and `margin` (per vertex) positive. Triangles for which `wanted(triangle)`
/// is false are passed over. Zero counts as positive, so that each side is crossed by both of its triangles or by
/// neither (simulation of simplicity). NaN crosses nothing.
template <typename Wanted, typename Value, typename Margin, typename Strength>
Curves trace_zero_set(const Surface& surface, const Wanted& wanted, const Value& value, const Margin& margin,
                      const Strength& strength) {
    const auto sides = triangle_sides(surface);
    return collect_pieces(surface.triangles.size(), [&](Index triangle, std::vector<CurvePiece>& out) {
        if (wanted(triangle)) append_zero(surface, *sides, triangle, value, margin, strength, out);
    });
}

/// All numbers that a field can have somewhere lie in it. Infinite or NaN where nothing is known: ask it in such a way
/// that this means "may be".
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

/// Curves where `value` is one of the levels: pieces of its own for each.
template <typename Value>
Curves trace_levels(const Surface& surface, const Value& value, float first, float step, int count) {
    const auto sides = triangle_sides(surface);
    return collect_pieces(surface.triangles.size(), [&](Index triangle, std::vector<CurvePiece>& out) {
        append_levels(surface, *sides, triangle, value, {first, step, count}, out);
    });
}

/// Appends the piece in one triangle of a curve along which a quantity is greatest across it; see trace_maxima.
template <typename Uphill, typename Margin, typename Strength>
void append_maximum(const Surface& surface, const TriangleSides& sides, Index triangle, const Uphill& uphill,
                    float least_bend, const Margin& margin, const Strength& strength, std::vector<CurvePiece>& out) {
    const glm::uvec3& of = sides.of_triangle[triangle];
    Crossing ends[3];
    int count = 0;
    bool climbs = false;
    float bend = 0.0f;
    for (int i = 0; i < 3; ++i) {
        const Edge e = sides.vertices[of[i]];
        const vec3 a = uphill(e.x), b = uphill(e.y);
        if (!(glm::dot(a, b) <= 0.0f)) continue;
        const float la = glm::length(a), lb = glm::length(b);
        if (!(la + lb > 0.0f)) continue;
        ends[count++] = {of[i], e.x, e.y, la / (la + lb)};
        // A maximum: at least one end climbs towards the other.
        const vec3 along = surface.positions[e.y] - surface.positions[e.x];
        bend = std::max(bend, (la + lb) / glm::length(along));
        climbs = climbs || glm::dot(a, along) >= 0.0f || glm::dot(b, along) <= 0.0f;
    }
    // Three crossings: the directions do not agree in this triangle, near an umbilic or in noise.
    if (count != 2 || !climbs || bend < least_bend) return;
    const Crossing two[2] = {ends[0], ends[1]};
    append_trimmed(surface, triangle, two, {two[0].mix(margin), two[1].mix(margin)}, strength, out);
}

/// Curves along which a quantity is greatest across them. `uphill(v)`: a vector at each vertex along which the quantity
/// grows, of the length of its derivative; its line matters, not the way it was turned (the derivative turns around with
/// the direction). A side is crossed where its two vectors point against each other. `margin`, `wanted` and `strength`
/// as above. Ohtake, Belyaev & Seidel, "Ridge-Valley Lines on Meshes via Implicit Surface Fitting", SIGGRAPH 2004, 4.
template <typename Wanted, typename Uphill, typename Margin, typename Strength>
Curves trace_maxima(const Surface& surface, const Wanted& wanted, const Uphill& uphill, float least_bend,
                    const Margin& margin, const Strength& strength) {
    const auto sides = triangle_sides(surface);
    return collect_pieces(surface.triangles.size(), [&](Index triangle, std::vector<CurvePiece>& out) {
        if (wanted(triangle)) append_maximum(surface, *sides, triangle, uphill, least_bend, margin, strength, out);
    });
}

}  // namespace fovea
