// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/folds.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/parallel.h>
#include <fovea/field/turn.h>

namespace fovea::line {
namespace {

/// How clearly an edge stands out: how much it turns, as a share of the angle asked for, and how many times as much as
/// the surface does beside it, about the edge's direction (a row of like edges is a rounded shape) and in all
/// directions (noise).
struct Prominence {
    double turn, than_parallel, than_around;
};
struct Limits {
    Prominence start, onward;
    double always;  // turn from which an edge is on a fold whatever lies beside it, in radians
};
Limits limits_for(Shape shape) {
    if (shape == Shape::hard) return {{1.0, 1.9, 6.0}, {0.7, 1.75, 4.0}, glm::radians(75.0)};
    if (shape == Shape::rounded) return {{1.5, 2.0, 6.0}, {1.0, 1.75, 4.0}, HUGE_VAL};
    return {{1.5, 2.5, 8.0}, {1.0, 2.0, 6.0}, HUGE_VAL};
}
constexpr double bridge = 0.5;              // share of the angle from which an edge joins two ends of folds
constexpr double flat = glm::radians(1.0);  // edges that turn less are looked across, as between triangles of a face
constexpr double parallel_cosine = 0.7071;  // of directions that count as parallel
constexpr double straight_cosine = 0.6428;  // a fold continues along an edge that turns by up to 50 degrees

class Folds {
   public:
    Folds(const Surface& surface, double angle, Shape shape)
        : surface_(surface),
          angle_(glm::radians(angle)),
          limits_(limits_for(shape)),
          turn_(parallel_map<float>(surface.edges.size(), [&](auto e) {
              return static_cast<float>(field::signed_turn(surface, static_cast<Index>(e)));
          })) {
        at_vertex_ = lists_of<Index>(surface.vertex_count(), [&](const auto& give) {
            for (Index e = 0; e < surface.mesh_edges; ++e)
                for (const Index v : {surface.edges[e].x, surface.edges[e].y}) give(v, e);
        });
        triangles_ = lists_of<Index>(surface.vertex_count(), [&](const auto& give) {
            for (Index t = 0; t < surface.triangles.size(); ++t)
                for (int k = 0; k < 3; ++k) give(surface.triangles[t][k], t);
        });
        of_facet_ = lists_of<Index>(surface.facet_count(), [&](const auto& give) {
            for (Index e = 0; e < surface.edges.size(); ++e)
                for (const EdgeSide side : surface.sides(e)) give(side.facet(), e);
        });
    }

    Array<std::uint8_t> find(double least) const {
        const auto grade = parallel_map<std::uint8_t>(surface_.mesh_edges, [&](std::size_t e) -> std::uint8_t {
            return stands_out(Index(e), limits_.start) ? 2 : stands_out(Index(e), limits_.onward) ? 1 : 0;
        });
        auto on =
            parallel_map<std::uint8_t>(grade.size(), [&](std::size_t e) -> std::uint8_t { return grade[e] == 2; });
        for (Index e = 0; e < on.size(); ++e)
            if (grade[e] == 2)
                for (const Index v : {surface_.edges[e].x, surface_.edges[e].y}) go_on(v, e, grade, on);
        if (least > 0.0) drop_short(least, on);
        return on;
    }

   private:
    bool stands_out(Index edge, const Prominence& by) const {
        const double turn = std::abs(turn_[edge]);
        if (surface_.edge_rows.size(edge) != 2 || turn < by.turn * angle_) return false;
        return turn > limits_.always ||
               (turn >= by.than_parallel * turn_parallel(edge) && turn >= by.than_around * turn_around(edge));
    }

    /// Unit vector from a vertex along an edge.
    dvec3 from(Index vertex, Index edge) const {
        const Edge e = surface_.edges[edge];
        const dvec3 d = dvec3(surface_.positions[e.x == vertex ? e.y : e.x]) - dvec3(surface_.positions[vertex]);
        const double length = glm::length(d);
        return length > 0.0 ? d / length : dvec3(0.0);
    }
    dvec3 direction(Index edge) const { return from(surface_.edges[edge].x, edge); }

    /// Mean over both sides of an edge of how much the surface turns at the next edge parallel to it.
    double turn_parallel(Index edge) const {
        const In<EdgeSide> sides = surface_.sides(edge);
        const dvec3 along = direction(edge);
        return 0.5 *
               (next_turn(edge, edge, sides[0].facet(), along, 2) + next_turn(edge, edge, sides[1].facet(), along, 2));
    }

    /// The greatest turn, the same way as at the edge `of`, at a facet's edges parallel to `along`, without `edge`;
    /// across up to `flats` flat edges.
    double next_turn(Index of, Index edge, Index facet, const dvec3& along, int flats) const {
        double most = 0.0;
        for (const Index other : of_facet_[facet]) {
            if (other == edge) continue;
            if (std::abs(turn_[other]) >= flat) {
                if (turn_[other] * turn_[of] < 0.0f) continue;
                if (std::abs(glm::dot(direction(other), along)) > parallel_cosine)
                    most = std::max<double>(most, std::abs(turn_[other]));
            } else if (flats > 0 && surface_.edge_rows.size(other) == 2) {
                const In<EdgeSide> sides = surface_.sides(other);
                const Index across = sides[0].facet() == facet ? sides[1].facet() : sides[0].facet();
                most = std::max(most, next_turn(of, other, across, along, flats - 1));
            }
        }
        return most;
    }

    /// Mean angle between the triangles around both ends of an edge and whichever of its facets is closer in direction.
    double turn_around(Index edge) const {
        const In<EdgeSide> sides = surface_.sides(edge);
        const auto normal = [&](Index facet) { return dvec3(surface_.facet_plane[facet]); };
        const dvec3 first = normal(sides[0].facet()), second = normal(sides[1].facet());
        double sum = 0.0;
        Index count = 0;
        for (const Index v : {surface_.edges[edge].x, surface_.edges[edge].y})
            for (const Index t : triangles_[v]) {
                const dvec3 n = normal(surface_.triangle_facet[t]);
                sum += std::acos(std::clamp(std::max(glm::dot(n, first), glm::dot(n, second)), -1.0, 1.0));
                ++count;
            }
        return count ? sum / count : 0.0;
    }

    /// Continues a fold that ends at a vertex with `edge`, along edges that stand out less, straightest first.
    void go_on(Index vertex, Index edge, In<std::uint8_t> grade, Array<std::uint8_t>& on) const {
        const auto ends_here = [&](Index v) {
            return std::ranges::count_if(at_vertex_[v], [&](Index e) { return on[e]; }) == 1;
        };
        while (ends_here(vertex)) {
            Index next = none;
            double best = straight_cosine;
            for (const Index e : at_vertex_[vertex]) {
                const Index across = surface_.edges[e].x == vertex ? surface_.edges[e].y : surface_.edges[e].x;
                const bool bridges = std::abs(turn_[e]) >= bridge * angle_ && ends_here(across);
                if (on[e] || !(grade[e] || bridges)) continue;
                const double cosine = -glm::dot(from(vertex, edge), from(vertex, e));
                if (cosine > best) next = e, best = cosine;
            }
            if (next == none) return;
            on[next] = 1;
            vertex = surface_.edges[next].x == vertex ? surface_.edges[next].y : surface_.edges[next].x;
            edge = next;
        }
    }

    /// Clears folds of one edge, and those shorter than `least`, that touch no edge that is marked sharp.
    void drop_short(double least, Array<std::uint8_t>& on) const {
        DisjointSets folds(surface_.vertex_count());
        for (Index e = 0; e < on.size(); ++e)
            if (on[e]) folds.join(surface_.edges[e].x, surface_.edges[e].y);
        Array<double> length(surface_.vertex_count(), 0.0);
        Array<Index> count(surface_.vertex_count(), 0);
        for (Index e = 0; e < on.size(); ++e) {
            const Edge ends = surface_.edges[e];
            if (on[e]) {
                const Index fold = folds.name(ends.x);
                length[fold] += glm::distance(dvec3(surface_.positions[ends.x]), dvec3(surface_.positions[ends.y]));
                ++count[fold];
            } else if (surface_.edge_marks[e] & mesh::mark_sharp) {
                for (const Index v : {ends.x, ends.y}) length[folds.name(v)] += least, count[folds.name(v)] += 2;
            }
        }
        for (Index e = 0; e < on.size(); ++e) {
            const Index fold = folds.name(surface_.edges[e].x);
            if (on[e] && (count[fold] == 1 || length[fold] < least)) on[e] = 0;
        }
    }

    const Surface& surface_;
    double angle_;
    Limits limits_;
    Array<float> turn_;       // per edge, radians; negative where concave
    Lists<Index> at_vertex_;  // mesh edges
    Lists<Index> triangles_;  // around each vertex
    Lists<Index> of_facet_;   // edges
};

}  // namespace

Array<std::uint8_t> find_folds(const Surface& surface, Shape shape, double angle, double least) {
    return Folds(surface, angle, shape).find(least);
}

}  // namespace fovea::line
