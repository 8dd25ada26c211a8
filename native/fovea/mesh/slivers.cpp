// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/slivers.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <vector>

namespace fovea::mesh {
namespace {

/// Height of a triangle, as a share of its longest side, up to which it is a sliver; and distance from a plane, as a
/// share of the same, up to which a sliver lies in it.
constexpr double thin = 0.01;

double squared(const dvec3& v) { return glm::dot(v, v); }

bool is_sliver(const TriangleSize& size) {
    return !(squared(size.area) > thin * thin * size.longest_squared * size.longest_squared);
}

/// Whether a triangle lies in the plane of another one.
bool lies_in_plane(const Array<vec3>& positions, const Triangle& triangle, const Triangle& other) {
    const dvec3 area = size_of(positions, other).area, origin(positions[other.x]);
    const double limit = thin * std::sqrt(size_of(positions, triangle).longest_squared * squared(area));
    const auto is_near = [&](Index v) { return std::abs(glm::dot(area, dvec3(positions[v]) - origin)) <= limit; };
    return is_near(triangle.x) && is_near(triangle.y) && is_near(triangle.z);
}

/// A side of a triangle, its vertices ascending.
struct Side {
    Index low, high, triangle;
};

/// A side across which the triangle `to` may go with `from`.
struct Link {
    double length;
    Index low, high, from, to;
    bool operator<(const Link& other) const {  // a priority queue begins with its greatest
        return std::tie(length, other.low, other.high) < std::tie(other.length, low, high);
    }
};

/// Sides between triangles, as links both ways, by `from`.
std::vector<Link> links_between(const Array<vec3>& positions, const Array<Triangle>& triangles, Index begin,
                                Index end) {
    std::vector<Side> sides;
    for (Index t = begin; t < end; ++t)
        for (int i = 0; i < 3; ++i) {
            const Index a = triangles[t][i], b = triangles[t][(i + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), t});
        }
    std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.low, s.high, s.triangle); });
    std::vector<Link> links;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const Side &a = sides[i], &b = sides[i + 1];
        if (a.low != b.low || a.high != b.high) continue;
        const double length = squared(dvec3(positions[a.high]) - dvec3(positions[a.low]));
        links.push_back({length, a.low, a.high, a.triangle, b.triangle});
        links.push_back({length, a.low, a.high, b.triangle, a.triangle});
    }
    std::ranges::stable_sort(links, {}, &Link::from);
    return links;
}

}  // namespace

TriangleSize size_of(const Array<vec3>& positions, const Triangle& triangle) {
    const dvec3 p(positions[triangle.x]), q(positions[triangle.y]), r(positions[triangle.z]);
    return {area_vector(positions, triangle), std::max({squared(q - p), squared(r - q), squared(p - r)})};
}

Index find_leaders(const Array<vec3>& positions, const Array<Triangle>& triangles, Index begin, Index end,
                   Array<Index>& leader) {
    Index slivers = 0;
    for (Index t = begin; t < end; ++t) {
        const bool goes_along = is_sliver(size_of(positions, triangles[t]));
        leader[t] = goes_along ? none : t;
        slivers += goes_along;
    }
    if (slivers == 0) return end - begin;
    if (slivers < end - begin) {
        const std::vector<Link> links = links_between(positions, triangles, begin, end);
        std::priority_queue<Link> open;
        const auto go_on_from = [&](Index t) {
            for (const Link& link : std::ranges::equal_range(links, t, {}, &Link::from))
                if (leader[link.to] == none) open.push(link);
        };
        for (Index t = begin; t < end; ++t)
            if (leader[t] == t) go_on_from(t);
        while (!open.empty()) {
            const Link next = open.top();
            open.pop();
            const Index of = leader[next.from];
            if (leader[next.to] != none || !lies_in_plane(positions, triangles[next.to], triangles[of])) continue;
            leader[next.to] = of;
            go_on_from(next.to);
        }
    }
    Index leaders = 0;
    for (Index t = begin; t < end; ++t) {
        if (leader[t] == none) leader[t] = t;
        leaders += leader[t] == t;
    }
    return leaders;
}

}  // namespace fovea::mesh
