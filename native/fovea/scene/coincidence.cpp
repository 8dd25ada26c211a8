// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/coincidence.h>

#include <array>
#include <cmath>
#include <limits>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/elementary.h>
#include <fovea/mesh/triangle_sides.h>
#include <fovea/scene/nearest.h>

namespace fovea::scene {
namespace {

/// Sine of the angle between two triangles from which their crossing is no coincidence. Triangles of two meshes of one
/// shape lie at up to the angle between neighboring triangles.
constexpr double steep_sine = 0.42;
/// Share of its crossings at smaller angles from which a curve is looked at.
constexpr double flat_share = 0.25;

/// How far to look, in Scale::side, and how near, in Scale::near.
constexpr double farthest_sides = 3.0, nearest_sides = 0.5;
/// Distance between surfaces beside each other, as a share of that from the crossing.
constexpr double slope = 0.02;
/// Angle up to which a triangle and its neighbors stand for a smooth surface.
constexpr double smooth_angle = 0.6;
/// Shortest rest of a curve, and longest gap in it that is closed, in Scale::side.
constexpr double shortest_rest = 4.0, longest_gap = 1.0;

/// A surface in the space of the crossings.
class Side {
   public:
    explicit Side(const Mapped& in) : in_(in), to_own_(glm::inverse(dmat4(in.map))) {
        nearest_ = *in.surface.cache().get<std::shared_ptr<const NearestPoint>>(
            0, [&] { return std::make_shared<const NearestPoint>(in.surface.positions, in.surface.triangles); });
    }
    std::optional<dvec3> nearest(const dvec3& p) const {
        const auto there = (*nearest_)(vec3(to_own_ * dvec4(p, 1.0)));
        return there ? std::optional(in_.map * dvec4(*there, 1.0)) : std::nullopt;
    }
    dvec3 corner(Index triangle, int i) const { return in_.corner(triangle, i); }

   private:
    const Mapped& in_;
    dmat4 to_own_;
    std::shared_ptr<const NearestPoint> nearest_;
};

dvec3 normal_of(const Mapped& in, Index triangle) {
    const dvec3 a = in.corner(triangle, 0);
    return glm::cross(in.corner(triangle, 1) - a, in.corner(triangle, 2) - a);
}

double longest_side(const Mapped& in, Index triangle) {
    double longest = 0.0;
    for (int i = 0; i < 3; ++i)
        longest = std::max(longest, glm::distance(in.corner(triangle, i), in.corner(triangle, (i + 1) % 3)));
    return longest;
}

/// A crossing as a part of its curve.
struct Part {
    double length;
    bool flat;          ///< the angle between its triangles is small
    double side = 0.0;  ///< Scale::side
};

Part part_of(const Crossing& crossing, const Mapped& first, const Mapped& second) {
    const dvec3 a = normal_of(first, crossing.triangle[0]), b = normal_of(second, crossing.triangle[1]);
    return {glm::distance(dvec3(crossing.point[0]), dvec3(crossing.point[1])),
            glm::length(glm::cross(a, b)) <= steep_sine * glm::length(a) * glm::length(b)};
}

/// Largest angle between a triangle and its neighbors, at most pi / 2.
double turn_at(const Mapped& in, Index triangle) {
    const dvec3 normal = normal_of(in, triangle);
    const auto sides = triangle_sides(in.surface);
    const auto at = triangles_at_sides(in.surface);
    double angle = 0.0;
    for (int i = 0; i < 3; ++i)
        for (const Index other : (*at)[sides->of_triangle[triangle][i]]) {
            const dvec3 there = normal_of(in, other), turn = glm::cross(normal, there);
            angle = std::max(angle, angle_of(glm::length(turn), std::abs(glm::dot(normal, there))));
        }
    return angle;
}

/// Lengths by which a crossing is judged. Only triangles that stand for a smooth surface with their neighbors make
/// crossings at random, and as far as they reach: a long face of a box does not.
struct Scale {
    double side = 0.0;  ///< longest side of its smooth triangles; where there is none, the shorter one of both
    double near = std::numeric_limits<double>::infinity();  ///< the shorter one of both longest sides
    /// How far the smooth triangles may be from the surfaces they stand for: twice the height of an arc that turns by
    /// their angle over their longest side.
    double room = 0.0;

    Scale(const Crossing& crossing, const Mapped& first, const Mapped& second) {
        const Mapped* const in[2] = {&first, &second};
        for (int i = 0; i < 2; ++i) {
            const double longest = longest_side(*in[i], crossing.triangle[i]);
            near = std::min(near, longest);
            const double angle = turn_at(*in[i], crossing.triangle[i]);
            if (angle >= smooth_angle) continue;
            side = std::max(side, longest);
            room += 0.25 * angle * longest;
        }
        if (side == 0.0) side = near;
    }
};

/// Finds whether the surfaces of a crossing stay beside each other.
class Beside {
   public:
    Beside(const Crossing& crossing, const Mapped& first, const Mapped& second)
        : scale_(crossing, first, second), middle_(0.5 * (dvec3(crossing.point[0]) + dvec3(crossing.point[1]))) {
        const dvec3 along = dvec3(crossing.point[1]) - dvec3(crossing.point[0]);
        const Mapped* const in[2] = {&first, &second};
        for (int i = 0; i < 2; ++i) {
            const Index triangle = crossing.triangle[i];
            up_[i] = glm::normalize(normal_of(*in[i], triangle));
            across_[i] = glm::normalize(glm::cross(up_[i], along));
        }
        if (glm::dot(across_[0], across_[1]) < 0.0) across_[1] = -across_[1];
    }

    /// On one side of the crossing. False for triangles without area.
    bool on_one_side(const Side& first, const Side& second) const {
        for (const double sign : {1.0, -1.0})
            if (stays(sign * across_[0], up_[0], first, second) && stays(sign * across_[1], up_[1], second, first))
                return true;
        return false;
    }

   private:
    /// Whether `here`, gone along `across`, stays beside `there`. False where it ends at once.
    bool stays(const dvec3& across, const dvec3& up, const Side& here, const Side& there) const {
        if (!(scale_.near > 0.0)) return false;
        bool seen = false;
        for (double way = farthest_sides * scale_.side; way >= nearest_sides * scale_.near; way *= 0.5) {
            const auto at = here.nearest(middle_ + way * across);
            if (!at) return false;
            const double gone = glm::distance(*at, middle_);
            if (gone < 0.1 * way) continue;
            const auto other = there.nearest(*at);
            // its height: `there` may end before
            if (!other || !(std::abs(glm::dot(*at - *other, up)) <= std::max(slope * gone, scale_.room))) return false;
            seen = true;
        }
        return seen;
    }

    Scale scale_;
    dvec3 middle_, up_[2], across_[2];
};

/// Parts of curves: crossings of equal `mark` that are connected, and their measures.
class Stretches {
   public:
    Stretches(const Crossings& crossings, In<Part> parts, In<std::uint8_t> mark)
        : sets_(crossings.size()), length_(crossings.size(), 0.0), sides_(length_) {
        Index ends = 0;
        for (const Crossing& c : crossings) ends = std::max({ends, c.end[0] + 1, c.end[1] + 1});
        std::array<Array<Index>, 2> at{Array<Index>(ends, none), Array<Index>(ends, none)};
        for (Index i = 0; i < crossings.size(); ++i)
            for (const Index end : crossings[i].end) {
                Index& other = at[mark[i]][end];
                if (other == none) other = i;
                sets_.join(other, i);
            }
        for (Index i = 0; i < crossings.size(); ++i) {
            length_[sets_.name(i)] += parts[i].length;
            sides_[sets_.name(i)] += parts[i].length * parts[i].side;
        }
    }
    Index name(Index i) { return sets_.name(i); }
    double length(Index i) { return length_[sets_.name(i)]; }
    /// Length in Scale::side, averaged over the length.
    double sides(Index i) { return length(i) * length(i) / std::max(sides_[sets_.name(i)], 1e-300); }

   private:
    DisjointSets sets_;
    Array<double> length_, sides_;
};

}  // namespace

Crossings without_coincidence(const Crossings& crossings, const Mapped& first, const Mapped& second,
                              const Cancel& cancel) {
    Array<Part> parts =
        parallel_map<Part>(crossings.size(), [&](std::size_t i) { return part_of(crossings[i], first, second); });
    Array<std::uint8_t> removed(crossings.size(), 0);
    Stretches curves(crossings, parts, removed);
    Array<double> flat(crossings.size(), 0.0);
    for (Index i = 0; i < parts.size(); ++i)
        if (parts[i].flat) flat[curves.name(i)] += parts[i].length;
    Array<Index> asked;
    for (Index i = 0; i < parts.size(); ++i)
        if (parts[i].flat && flat[curves.name(i)] >= flat_share * curves.length(i)) asked.push_back(i);
    if (asked.empty()) return crossings;
    const Side here(first), there(second);
    parallel_blocks(asked.size(), 64, [&](auto, std::size_t begin, std::size_t end) {
        cancel.poll();
        for (std::size_t k = begin; k < end; ++k) {
            const Crossing& c = crossings[asked[k]];
            removed[asked[k]] = Beside(c, first, second).on_one_side(here, there);
        }
    });
    parallel_for(parts.size(), [&](std::size_t i) { parts[i].side = Scale(crossings[i], first, second).side; });
    // Of curves with both, first rests between removed parts go, then gaps between the rests that are left.
    for (const bool gaps : {false, true}) {
        Array<std::uint8_t> holds(crossings.size(), 0);
        for (Index i = 0; i < parts.size(); ++i) holds[curves.name(i)] |= removed[i] ? 1 : 2;
        Stretches stretches(crossings, parts, removed);
        for (Index i = 0; i < parts.size(); ++i)
            if (holds[curves.name(i)] == 3 && bool(removed[i]) == gaps &&
                stretches.sides(i) < (gaps ? longest_gap : shortest_rest))
                removed[i] = !gaps;
    }
    return values_where(crossings, [&](std::size_t i) { return !removed[i]; });
}

}  // namespace fovea::scene
