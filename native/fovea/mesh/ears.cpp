// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/ears.h>

#include <algorithm>
#include <array>

namespace fovea::mesh {
namespace {

/// Projection along the dominant axis of Newell's normal; counterclockwise.
std::vector<dvec2> flattened(In<vec3> corners) {
    dvec3 normal(0.0);
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += glm::cross(dvec3(corners[i]), dvec3(corners[(i + 1) % corners.size()]));
    const dvec3 size = glm::abs(normal);
    const int dropped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double turned = normal[dropped] < 0.0 ? -1.0 : 1.0;
    std::vector<dvec2> flat;
    for (const vec3& p : corners) flat.emplace_back(p[(dropped + 1) % 3], turned * p[(dropped + 2) % 3]);
    return flat;
}

/// Twice the signed area of a triangle; positive if it is counterclockwise.
double turn(const dvec2& a, const dvec2& b, const dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Doubly linked ring of the corners that are left, with the list of reflex (or flat) ones.
class Ring {
   public:
    explicit Ring(std::vector<dvec2> points) : points_(std::move(points)) {
        const Index count = Index(points_.size());
        for (Index i = 0; i < count; ++i) {
            before_.push_back((i + count - 1) % count);
            after_.push_back((i + 1) % count);
        }
        for (Index i = 0; i < count; ++i)
            if (is_hollow(i)) hollow_.push_back(i);
    }

    Index after(Index corner) const { return after_[corner]; }
    Triangle triangle(Index corner) const { return {before_[corner], corner, after_[corner]}; }

    /// Whether the corner is convex and its triangle contains no other corner; only reflex corners need testing.
    bool is_ear(Index corner) const {
        if (is_hollow(corner)) return false;
        const auto [a, b, c] = std::array{points_[before_[corner]], points_[corner], points_[after_[corner]]};
        return std::none_of(hollow_.begin(), hollow_.end(), [&](Index other) {
            const dvec2& p = points_[other];
            return p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
        });
    }

    void cut(Index corner) {
        after_[before_[corner]] = after_[corner];
        before_[after_[corner]] = before_[corner];
        const auto [before, after] = std::pair(before_[corner], after_[corner]);
        std::erase_if(hollow_, [&](Index other) {
            return other == corner || ((other == before || other == after) && !is_hollow(other));
        });
    }

   private:
    bool is_hollow(Index corner) const {
        return !(turn(points_[before_[corner]], points_[corner], points_[after_[corner]]) > 0.0);
    }

    std::vector<dvec2> points_;
    std::vector<Index> before_, after_, hollow_;
};

}  // namespace

std::vector<Triangle> cut_ears(In<vec3> corners) {
    std::vector<Triangle> triangles;
    if (corners.size() < 3) return triangles;
    Ring ring(flattened(corners));
    Index corner = 0;
    for (std::size_t left = corners.size(), looked_at = 0; left > 3;) {
        const Index next = ring.after(corner);
        if (ring.is_ear(corner) || looked_at >= left) {  // no ear in a full round: self-intersecting
            triangles.push_back(ring.triangle(corner));
            ring.cut(corner);
            --left;
            looked_at = 0;
        } else {
            ++looked_at;
        }
        corner = next;
    }
    triangles.push_back(ring.triangle(corner));
    return triangles;
}

}  // namespace fovea::mesh
