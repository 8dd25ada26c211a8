// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/bend_directions.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/mesh/triangle_sides.h>

namespace fovea::field {
namespace {

const double least_cosine = cosine(glm::radians(40.0));
/// Bends are averaged over the same share of a surface's area, however fine it is: on a graph of at most so many nodes,
/// one time for so many of them; and a few times on the way back to finer ones.
constexpr Index most_nodes = 20'000, nodes_per_time = 440;
constexpr Index least_times = 2;
/// Averages of directions, once chosen, take so much less.
constexpr Index times_fewer = 4;
/// Difference of principal curvatures, over their sum, from which on the greater one is meant wherever that leads.
constexpr double strong = 0.5;
/// Difference of principal curvatures, over the reciprocal of the surface's radius, that counts as much as the
/// direction which stands in for unclear ones.
constexpr double clear = 0.05;

/// Symmetric: xx, yy, zz, xy, yz, zx.
struct Tensor {
    dvec3 diagonal{0.0}, rest{0.0};
    Tensor& operator+=(const Tensor& other) {
        diagonal += other.diagonal, rest += other.rest;
        return *this;
    }
    friend Tensor operator+(Tensor a, const Tensor& b) { return a += b; }
    friend Tensor operator*(double factor, const Tensor& t) { return {factor * t.diagonal, factor * t.rest}; }
    static Tensor of(const dvec3& d, double weight) {
        return {weight * d * d, weight * dvec3(d.x * d.y, d.y * d.z, d.z * d.x)};
    }
    double operator()(const dvec3& a, const dvec3& b) const {
        return glm::dot(diagonal, a * b) + rest.x * (a.x * b.y + a.y * b.x) + rest.y * (a.y * b.z + a.z * b.y) +
               rest.z * (a.z * b.x + a.x * b.z);
    }
};

/// What is averaged.
struct Bent {
    Tensor bends;
    double area = 0.0;
    Bent& operator+=(const Bent& other) {
        bends += other.bends, area += other.area;
        return *this;
    }
};

/// Nodes and their neighbors.
using Graph = Lists<Index>;

/// Half of what is at a node, and half of the mean of its neighbors.
Array<Bent> averaged(const Graph& graph, const Array<Bent>& values, Index times) {
    Array<Bent> now = values;
    for (Index i = 0; i < times; ++i)
        now = parallel_map<Bent>(now.size(), [&](std::size_t node) {
            const In<Index> others = graph[Index(node)];
            if (others.empty()) return now[node];
            Bent sum;
            for (const Index other : others) sum += now[other];
            const double share = 0.5 / double(others.size());
            return Bent{0.5 * now[node].bends + share * sum.bends, 0.5 * now[node].area + share * sum.area};
        });
    return now;
}

/// Each node that is in no cluster yet, in order, makes one with those of its neighbors that are not, either.
Array<Index> clusters_of(const Graph& graph, Index& count) {
    Array<Index> of_node(graph.count(), none);
    count = 0;
    for (Index node = 0; node < graph.count(); ++node) {
        if (of_node[node] != none) continue;
        of_node[node] = count;
        for (const Index other : graph[node])
            if (of_node[other] == none) of_node[other] = count;
        ++count;
    }
    return of_node;
}

/// Averages by way of coarser graphs, where there are more nodes than `most_nodes` and clusters to be made; as many
/// times as fit, or so many times fewer.
Array<Bent> spread(const Graph& graph, const Array<Bent>& values, Index fewer = 1) {
    const Index nodes = graph.count(), per_time = nodes_per_time * fewer;
    if (nodes <= most_nodes) return averaged(graph, values, std::max(nodes / per_time, least_times));
    Index count = 0;
    const Array<Index> cluster = clusters_of(graph, count);
    if (count > nodes / 2) return averaged(graph, values, most_nodes / per_time);
    Lists<Index> pairs = lists_of<Index>(count, [&](const auto& give) {
        for (Index node = 0; node < nodes; ++node)
            for (const Index other : graph[node])
                if (cluster[node] != cluster[other]) give(cluster[node], cluster[other]);
    });
    Graph coarse;
    for (Index c = 0; c < count; ++c) {
        const std::span<Index> others = pairs[c];
        std::ranges::sort(others);
        coarse.values.insert(coarse.values.end(), others.begin(), std::ranges::unique(others).begin());
        coarse.offsets.push_back(Index(coarse.values.size()));
    }
    Array<Bent> sums(count, Bent{});
    for (Index node = 0; node < nodes; ++node) sums[cluster[node]] += values[node];
    const Array<Bent> found = spread(coarse, sums, fewer);
    Array<Bent> back(nodes, Bent{});
    for (Index node = 0; node < nodes; ++node) back[node] = found[cluster[node]];
    return averaged(graph, back, least_times);
}

class Finder {
   public:
    Finder(const Surface& surface, In<vec3> positions)
        : positions_(positions),
          triangles_(surface.triangles),
          sides_(*triangle_sides(surface)),
          at_sides_(*triangles_at_sides(surface)) {
        dvec3 low(HUGE_VAL), high(-HUGE_VAL);
        for (const Triangle& t : triangles_)
            for (int k = 0; k < 3; ++k) low = glm::min(low, at(t[k])), high = glm::max(high, at(t[k]));
        const double size = 0.5 * glm::distance(low, high);
        unclear_ = size > 0.0 && std::isfinite(size) ? clear / size : 0.0;
        smooth_ = parallel_map<std::uint8_t>(at_sides_.count(), [&](std::size_t side) {
            const auto here = at_sides_[Index(side)];
            return here.size() == 2 && goes_on(positions_, triangles_[here[0]], triangles_[here[1]]);
        });
        number_nodes();
    }

    BendDirections find() const {
        Array<Bent> bent(nodes_, Bent{});
        Array<dvec3> normal(nodes_, dvec3(0.0));
        for (Index t = 0; t < triangles_.size(); ++t) {
            const dvec3 area = area_vector(positions_, triangles_[t]);
            for (int k = 0; k < 3; ++k) {
                bent[node_[3 * t + k]].area += glm::length(area) / 6.0;
                normal[node_[3 * t + k]] += area;
            }
        }
        for (Index side = 0; side < smooth_.size(); ++side) {
            if (!smooth_[side]) continue;
            const Tensor bend = 0.5 * bend_at(side);
            for (const Index node : ends_of(side, at_sides_[side][0])) bent[node].bends += bend;
        }
        const Graph graph = lists_of<Index>(nodes_, [&](const auto& give) {
            for (Index side = 0; side < smooth_.size(); ++side)
                for (const Index t : at_sides_[side].first(smooth_[side] ? 1 : at_sides_[side].size())) {
                    const auto [a, b] = ends_of(side, t);
                    give(a, b), give(b, a);
                }
        });
        bent = spread(graph, bent);
        for (dvec3& n : normal) n = unit_or_zero(n);
        BendDirections found;
        for (Index node = 0; node < nodes_ && !found.any; ++node) found.any = is_clear(bent[node], normal[node]);
        if (found.any) bent = spread(graph, chosen(graph, bent, normal), times_fewer);
        const auto of_node =
            parallel_map<vec3>(nodes_, [&](std::size_t node) { return direction(bent[node], normal[node]); });
        found.corner.resize(triangles_.size());
        for (Index i = 0; i < node_.size(); ++i) found.corner[i / 3][i % 3] = of_node[node_[i]];
        return found;
    }

   private:
    dvec3 at(Index v) const { return dvec3(positions_[v]); }

    /// Corners at a vertex whose triangles go on smoothly into one another are one node.
    void number_nodes() {
        DisjointSets corners(3 * triangles_.size());
        for (Index side = 0; side < smooth_.size(); ++side) {
            if (!smooth_[side]) continue;
            for (const Index v : {sides_.vertices[side].x, sides_.vertices[side].y})
                corners.join(corner(at_sides_[side][0], v), corner(at_sides_[side][1], v));
        }
        node_.resize(3 * triangles_.size());
        for (Index i = 0; i < node_.size(); ++i) {
            const Index first = corners.name(i);
            node_[i] = first == i ? nodes_++ : node_[first];
        }
    }

    Index corner(Index triangle, Index vertex) const {
        return 3 * triangle + Index(corner_of(triangles_[triangle], vertex));
    }
    std::array<Index, 2> ends_of(Index side, Index triangle) const {
        const Edge& ends = sides_.vertices[side];
        return {node_[corner(triangle, ends.x)], node_[corner(triangle, ends.y)]};
    }

    /// The sine of the turn across a side times its length, positive where convex, on its direction.
    Tensor bend_at(Index side) const {
        const auto here = at_sides_[side];
        const Edge& ends = sides_.vertices[side];
        const Triangle& first = triangles_[here[0]];
        const bool forward = first[(corner_of(first, ends.x) + 1) % 3] == ends.y;
        const dvec3 along = (forward ? 1.0 : -1.0) * (at(ends.y) - at(ends.x));
        const dvec3 turned = glm::cross(unit_or_zero(area_vector(positions_, first)),
                                        unit_or_zero(area_vector(positions_, triangles_[here[1]])));
        const double weight = glm::dot(turned, along);
        return std::isfinite(weight) ? Tensor::of(unit_or_zero(along), weight) : Tensor{};
    }

    /// A tensor in a tangent plane with axes e1, which stands in for unclear directions, and e2.
    struct Form {
        dvec3 e1, e2;
        double a, b, c;  ///< (e1, e1), (e1, e2), (e2, e2)
    };

    static Form form(const Bent& of, const dvec3& n) {
        const dvec3 level = unit_or_zero(glm::cross(dvec3(0, 0, 1), n)),
                    around = level == dvec3(0.0) ? dvec3(1, 0, 0) : level;
        const dvec3 e1 = unit_or_zero(around - n * glm::dot(n, around)), e2 = glm::cross(n, e1);
        return {e1, e2, of.bends(e1, e1), of.bends(e1, e2), of.bends(e2, e2)};
    }

    bool is_clear(const Bent& of, const dvec3& n) const {
        const auto [e1, e2, a, b, c] = form(of, n);
        const double least = unclear_ * of.area;
        return (a - c) * (a - c) + 4.0 * b * b > least * least;
    }

    /// Where bends differ little from direction to direction, as on the belly of a vase, either principal direction
    /// will do: that which goes on from where they differ much. As bends in that direction alone.
    Array<Bent> chosen(const Graph& graph, const Array<Bent>& bent, const Array<dvec3>& normal) const {
        Array<dvec3> over(nodes_, dvec3(0.0));  // what it is folded over
        Array<double> difference(nodes_, 0.0);
        Array<Index> queue;
        Array<std::uint8_t> reached(nodes_, 0);
        for (Index node = 0; node < nodes_; ++node) {
            const auto [e1, e2, a, b, c] = form(bent[node], normal[node]);
            const double angle = 0.5 * angle_of(2.0 * b, a - c), half = std::sqrt(0.25 * (a - c) * (a - c) + b * b),
                         mean = 0.5 * (a + c);
            if (!std::isfinite(half + mean)) continue;
            over[node] = cosine(angle) * e1 + sine(angle) * e2;
            difference[node] = 2.0 * half;
            if (difference[node] > strong * (std::abs(mean + half) + std::abs(mean - half)) &&
                is_clear(bent[node], normal[node]))
                queue.push_back(node), reached[node] = 1;
        }
        for (std::size_t next = 0; next < queue.size(); ++next)
            for (const Index other : graph[queue[next]]) {
                if (reached[other]) continue;
                reached[other] = 1;
                queue.push_back(other);
                const dvec3 across = glm::cross(normal[other], over[other]), &from = over[queue[next]];
                if (std::abs(glm::dot(across, from)) > std::abs(glm::dot(over[other], from))) over[other] = across;
            }
        Array<Bent> found(nodes_, Bent{});
        for (Index node = 0; node < nodes_; ++node)
            found[node] = {Tensor::of(over[node], difference[node]), bent[node].area};
        return found;
    }

    /// Bends sum up along the edges that a surface is folded over, at right angles to which it bends.
    vec3 direction(const Bent& of, const dvec3& n) const {
        if (n == dvec3(0.0)) return vec3(0.0f);
        const auto [e1, e2, a, b, c] = form(of, n);
        if (!std::isfinite(a + b + c)) return vec3(e1);
        const double angle = 0.5 * angle_of(2.0 * b, a - (c + unclear_ * of.area));
        return vec3(cosine(angle) * e2 - sine(angle) * e1);
    }

    const In<vec3> positions_;
    const Array<Triangle>& triangles_;
    const TriangleSides& sides_;
    const Lists<Index>& at_sides_;
    Array<std::uint8_t> smooth_;  // per side: the surface goes on across it
    Array<Index> node_;           // per corner
    Index nodes_ = 0;
    double unclear_ = 0.0;
};

}  // namespace

bool goes_on(In<vec3> positions, const Triangle& one, const Triangle& other) {
    int shared = 0;
    for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
            if (one[k] == other[(l + 1) % 3] && one[(k + 1) % 3] == other[l]) ++shared;
    if (shared != 1) return false;
    const auto normal = [&](const Triangle& t) { return unit_or_zero(area_vector(positions, t)); };
    return glm::dot(normal(one), normal(other)) >= least_cosine;
}

std::shared_ptr<const BendDirections> bend_directions(const Surface& surface) {
    return surface.cache().get<BendDirections>(0, [&] {
        const In<vec3> positions = surface.rest().empty() ? In<vec3>(surface.positions) : surface.rest();
        return Finder(surface, positions).find();
    });
}

}  // namespace fovea::field
