// SPDX-License-Identifier: GPL-3.0-or-later
// How far the curvature falls beside a crest: little on tubes and limbs, whose crests are ripples of their mesh.
#include <cmath>
#include <limits>
#include <optional>

#include <fovea/line/crest.h>

namespace fovea::line {
namespace {

constexpr double turn = 0.5;         // radians of a circle of the crest's curvature
constexpr double least_edges = 2;    // longest sides of the crest's triangle
constexpr int most_triangles = 256;  // triangles on the way

/// Straight geodesics on a surface (Polthier & Schmies, "Straightest Geodesics on Polyhedral Surfaces", 1998).
class Walk {
   public:
    explicit Walk(const Surface& surface)
        : surface_(surface), sides_(triangle_sides(surface)), at_(triangles_at_sides(surface)) {}

    /// value (per vertex) at a distance from a point of a triangle; nothing where the surface ends before, or is not
    /// manifold. `along`: in the triangle's plane, of any length.
    template <typename Value>
    std::optional<double> value_at(Index triangle, dvec3 from, dvec3 along, double distance, const Value& value) const {
        along = glm::normalize(along);
        Index entered = none;
        for (int step = 0; step < most_triangles; ++step) {
            const Triangle& t = surface_.triangles[triangle];
            const dvec3 p[3] = {corner(t.x), corner(t.y), corner(t.z)};
            const dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
            double way = std::numeric_limits<double>::infinity();
            int out = -1;
            for (int i = 0; i < 3; ++i) {
                if (sides_->of_triangle[triangle][i] == entered) continue;
                const dvec3 outwards = glm::cross(p[(i + 1) % 3] - p[i], normal);
                const double speed = glm::dot(along, outwards), room = glm::dot(p[i] - from, outwards);
                if (speed > 0.0 && std::max(room, 0.0) / speed < way) {
                    way = std::max(room, 0.0) / speed;
                    out = i;
                }
            }
            if (out < 0) return std::nullopt;  // no area
            if (way >= distance) {
                const dvec3 at = from + distance * along;
                const double whole = glm::dot(normal, normal);
                const auto share = [&](int i) {
                    return glm::dot(normal, glm::cross(p[(i + 2) % 3] - p[(i + 1) % 3], at - p[(i + 1) % 3])) / whole;
                };
                return share(0) * value(t.x) + share(1) * value(t.y) + share(2) * value(t.z);
            }
            distance -= way;
            from += way * along;
            entered = sides_->of_triangle[triangle][out];
            const Index next = beyond(entered, triangle);
            if (next == none) return std::nullopt;
            const dvec3 side = glm::normalize(p[(out + 1) % 3] - p[out]);
            const dvec3 inwards = inwards_from(next, p[out], side);
            const double across = std::sqrt(std::max(0.0, 1.0 - glm::dot(along, side) * glm::dot(along, side)));
            along = glm::dot(along, side) * side + across * inwards;
            triangle = next;
        }
        return std::nullopt;
    }

    dvec3 corner(Index v) const { return dvec3(surface_.positions[v]); }

   private:
    /// The other triangle at a side; `none` if there is not exactly one.
    Index beyond(Index side, Index triangle) const {
        const auto there = (*at_)[side];
        if (there.size() != 2) return none;
        return there[0] == triangle ? there[1] : there[0];
    }
    /// Unit vector in a triangle's plane, from one of its sides towards its third corner.
    dvec3 inwards_from(Index triangle, const dvec3& on_side, const dvec3& side) const {
        const Triangle& t = surface_.triangles[triangle];
        dvec3 farthest(0.0);
        for (int i = 0; i < 3; ++i) {
            const dvec3 way = corner(t[i]) - on_side, off = way - glm::dot(way, side) * side;
            if (glm::dot(off, off) > glm::dot(farthest, farthest)) farthest = off;
        }
        const double length = glm::length(farthest);
        return length > 0.0 ? farthest / length : dvec3(0.0);
    }

    const Surface& surface_;
    std::shared_ptr<const TriangleSides> sides_;
    std::shared_ptr<const Lists<Index>> at_;
};

}  // namespace

Curves prominent(const Surface& surface, const Curves& crests, float sign, double least) {
    const auto fields = fields_of(surface);
    const Walk walk(surface);
    const auto k1 = [&](Index v) { return double(sign) * fields->curvature[v].k1; };
    const auto falls = [&](const CurvePiece& piece) {
        const Triangle& t = surface.triangles[piece.triangle];
        const Index top = k1(t.x) >= k1(t.y) ? (k1(t.x) >= k1(t.z) ? t.x : t.z) : (k1(t.y) >= k1(t.z) ? t.y : t.z);
        const dvec3 p[3] = {walk.corner(t.x), walk.corner(t.y), walk.corner(t.z)};
        const dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]), e1(fields->curvature[top].e1);
        const dvec3 along = glm::dot(normal, normal) * e1 - glm::dot(normal, e1) * normal;
        const dvec3 middle = 0.5 * (dvec3(piece.point[0]) + dvec3(piece.point[1]));
        const double here = k1(top);
        if (!(here > 0.0) || !(glm::length(along) > 0.0)) return false;
        const double longest =
            std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
        const double distance = std::max(turn / here, least_edges * longest);
        for (const double way : {1.0, -1.0}) {
            const auto there = walk.value_at(piece.triangle, middle, way * along, distance, k1);
            if (there && !(*there <= (1.0 - least) * here)) return false;
        }
        return true;
    };
    const auto kept = parallel_map<std::uint8_t>(crests.size(), [&](std::size_t i) { return falls(crests[i]); });
    return values_where(crests, [&](std::size_t i) { return kept[i]; });
}

}  // namespace fovea::line
