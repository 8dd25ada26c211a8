// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/contact.h>

#include <fovea/base/disjoint_sets.h>
#include <fovea/mesh/triangle_sides.h>

namespace fovea::scene {
namespace {

/// Length, in tolerances, that a curve must exceed; remainders of removed contact curves are shorter.
constexpr double shortest_curve = 16.0;

/// Plane of a triangle. For a triangle without area the normal is 0, and every point has height 0.
struct Plane {
    dvec3 normal{0.0};
    dvec3 point{0.0};

    Plane(const Mapped& in, Index triangle) : point(in.corner(triangle, 0)) {
        const dvec3 n = glm::cross(in.corner(triangle, 1) - point, in.corner(triangle, 2) - point);
        if (const double length = glm::length(n); length > 0.0) normal = n / length;
    }
    double height(const dvec3& p) const { return glm::dot(normal, p - point); }
};

class ContactTest {
   public:
    ContactTest(const Mapped& first, const Mapped& second, double tolerance)
        : mapped_{first, second}, tolerance_(tolerance) {}

    /// Whether the crossing runs along a side of one of its triangles at which that surface does not continue to the
    /// other side of the other triangle.
    bool touches(const Crossing& crossing) const {
        for (int own = 0; own < 2; ++own)
            for (int side = 0; side < 3; ++side)
                if (runs_along(crossing, own, side) && turns_back(crossing, own, side)) return true;
        return false;
    }

   private:
    bool runs_along(const Crossing& crossing, int own, int side) const {
        // Too short to have a reliable direction.
        if (glm::distance(dvec3(crossing.point[0]), dvec3(crossing.point[1])) <= 4.0 * tolerance_) return false;
        const Index t = crossing.triangle[own];
        const dvec3 from = mapped_[own].corner(t, side), along = mapped_[own].corner(t, (side + 1) % 3) - from;
        const double room = tolerance_ * glm::length(along);
        return glm::length(glm::cross(dvec3(crossing.point[0]) - from, along)) <= room &&
               glm::length(glm::cross(dvec3(crossing.point[1]) - from, along)) <= room;
    }

    bool turns_back(const Crossing& crossing, int own, int side) const {
        const Mapped& in = mapped_[own];
        const Index t = crossing.triangle[own];
        const Plane plane(mapped_[1 - own], crossing.triangle[1 - own]);
        const double here = plane.height(in.corner(t, (side + 2) % 3));
        const Index number = triangle_sides(in.surface)->of_triangle[t][side];
        const Edge ends = triangle_sides(in.surface)->vertices[number];
        for (const Index triangle : (*triangles_at_sides(in.surface))[number]) {
            const Triangle& beyond = in.surface.triangles[triangle];
            for (int k = 0; k < 3; ++k) {
                if (beyond[k] == ends.x || beyond[k] == ends.y) continue;
                const double there = plane.height(in.corner(triangle, k));
                if (std::min(std::abs(here), std::abs(there)) > tolerance_ && here * there < 0.0) return false;
            }
        }
        return true;
    }

    const Mapped mapped_[2];
    const double tolerance_;
};

/// Per crossing: total length of its curve, that is of all crossings connected to it by common ends.
Array<double> curve_lengths(const Crossings& crossings) {
    Index ends = 0;
    for (const Crossing& c : crossings) ends = std::max({ends, c.end[0] + 1, c.end[1] + 1});
    DisjointSets curves(ends);
    for (const Crossing& c : crossings) curves.join(c.end[0], c.end[1]);
    Array<double> total(ends, 0.0);
    for (const Crossing& c : crossings)
        total[curves.name(c.end[0])] += glm::distance(dvec3(c.point[0]), dvec3(c.point[1]));
    Array<double> lengths(crossings.size());
    for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] = total[curves.name(crossings[i].end[0])];
    return lengths;
}

}  // namespace

Crossings without_contact(const Crossings& crossings, const Mapped& first, const Mapped& second, double tolerance) {
    const ContactTest test(first, second, tolerance);
    Array<std::uint8_t> contact(crossings.size());
    parallel_for(crossings.size(), 256, [&](std::size_t i) { contact[i] = test.touches(crossings[i]); });
    const Crossings kept = values_where(crossings, [&](std::size_t i) { return !contact[i]; });
    const Array<double> lengths = curve_lengths(kept);
    return values_where(kept, [&](std::size_t i) { return lengths[i] > shortest_curve * tolerance; });
}

}  // namespace fovea::scene
