// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/folds.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/parallel.h>
#include <fovea/line/turns.h>

namespace fovea::line {
namespace {

/// How clearly an edge stands out: how much it turns, as a share of the angle asked for, and how many times as much as
/// the surface does beside it (line/turns.h): at the next parallel edges (a row of like edges is a rounded shape), in
/// all directions (noise), and on average at the next edges. 0: whatever lies there.
struct Prominence {
    double turn, than_parallel, than_around, than_alongside;
};
struct Hysteresis {
    Prominence start, onward;
};
struct Limits {
    Hysteresis convex, concave;
    double always;         // turn from which an edge is on a fold whatever lies beside it, in radians
    Index enough_concave;  // edges that keep a fold however short it is
};
Limits limits_for(Shape shape) {
    constexpr Hysteresis hard{{1.0, 1.9, 6.0, 0.0}, {0.7, 1.75, 4.0, 0.0}};
    constexpr Hysteresis rounded{{1.5, 2.0, 6.0, 0.0}, {1.0, 1.75, 4.0, 0.0}};
    constexpr Hysteresis hollow{{4.0 / 3.0, 0.0, 0.0, 2.25}, {1.0, 0.0, 0.0, 1.75}};
    constexpr Hysteresis smooth{{1.5, 2.5, 8.0, 0.0}, {1.0, 2.0, 6.0, 0.0}};
    if (shape == Shape::hard) return {hard, hard, glm::radians(75.0), none};
    if (shape == Shape::rounded) return {rounded, hollow, HUGE_VAL, 3};
    return {smooth, smooth, HUGE_VAL, none};
}
constexpr double bridge = 0.5;              // share of the angle from which an edge joins two ends of folds
constexpr int longest_bridge = 4;           // edges that do so together
constexpr double bridge_cosine = 0.5;       // and turn by up to 60 degrees, as lines are chained
constexpr double straight_cosine = 0.6428;  // a fold continues along an edge that turns by up to 50 degrees

class Folds {
   public:
    Folds(const field::FacetEdges& edges, double angle, Shape shape)
        : surface_(edges.surface), turns_(edges), angle_(glm::radians(angle)), limits_(limits_for(shape)) {
        at_vertex_ = lists_of<Index>(surface_.vertex_count(), [&](const auto& give) {
            for (Index e = 0; e < surface_.mesh_edges; ++e)
                for (const Index v : {surface_.edges[e].x, surface_.edges[e].y}) give(v, e);
        });
    }

    Array<std::uint8_t> find(const std::function<bool(double)>& is_short) const {
        const auto grade = parallel_map<std::uint8_t>(surface_.mesh_edges, [&](std::size_t e) -> std::uint8_t {
            const Hysteresis& by = turns_[Index(e)] < 0.0 ? limits_.concave : limits_.convex;
            return stands_out(Index(e), by.start) ? 2 : stands_out(Index(e), by.onward) ? 1 : 0;
        });
        auto on =
            parallel_map<std::uint8_t>(grade.size(), [&](std::size_t e) -> std::uint8_t { return grade[e] == 2; });
        for (Index e = 0; e < on.size(); ++e)
            if (grade[e] == 2)
                for (const Index v : {surface_.edges[e].x, surface_.edges[e].y}) go_on(v, e, grade, on);
        if (is_short) drop_short(is_short, on);
        return on;
    }

   private:
    bool stands_out(Index edge, const Prominence& by) const {
        const double turn = std::abs(turns_[edge]);
        if (surface_.edge_rows.size(edge) != 2 || turn < by.turn * angle_) return false;
        const auto is_more = [&](double times, double (Turns::*than)(Index) const) {
            return times == 0.0 || turn >= times * (turns_.*than)(edge);
        };
        return turn > limits_.always ||
               (is_more(by.than_parallel, &Turns::parallel) && is_more(by.than_around, &Turns::around) &&
                is_more(by.than_alongside, &Turns::alongside));
    }

    /// The other vertex of an edge.
    Index across(Index vertex, Index edge) const {
        return surface_.edges[edge].x == vertex ? surface_.edges[edge].y : surface_.edges[edge].x;
    }

    /// Unit vector from a vertex along an edge.
    dvec3 from(Index vertex, Index edge) const {
        const Edge e = surface_.edges[edge];
        const dvec3 d = dvec3(surface_.positions[e.x == vertex ? e.y : e.x]) - dvec3(surface_.positions[vertex]);
        const double length = glm::length(d);
        return length > 0.0 ? d / length : dvec3(0.0);
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
                const bool bridges = std::abs(turns_[e]) >= bridge * angle_ && ends_here(across(vertex, e));
                if (on[e] || !(grade[e] || bridges)) continue;
                const double cosine = -glm::dot(from(vertex, edge), from(vertex, e));
                if (cosine > best) next = e, best = cosine;
            }
            if (next == none) return span_gap(vertex, edge, on);
            on[next] = 1;
            vertex = across(vertex, next);
            edge = next;
        }
    }

    /// Continues a fold that ends at a vertex with `edge` to the end of another one that goes the same way, over a few
    /// edges that turn less, in the same sense.
    void span_gap(Index vertex, Index edge, Array<std::uint8_t>& on) const {
        Index way[longest_bridge];
        const int edges = way_to_fold(vertex, edge, on, way, 0);
        for (int i = 0; i < edges; ++i) on[way[i]] = 1;
    }

    /// Number of edges of `way`, of which the first `count` lead to a vertex, to the nearest fold in its direction,
    /// straightest first; 0: there is none.
    int way_to_fold(Index vertex, Index edge, In<std::uint8_t> on, Index (&way)[longest_bridge], int count) const {
        struct Step {
            double cosine;
            Index edge;
        };
        std::vector<Step> steps;
        for (const Index e : at_vertex_[vertex]) {
            const double cosine = -glm::dot(from(vertex, edge), from(vertex, e));
            if (e == edge || !(cosine > bridge_cosine)) continue;
            if (on[e]) {
                if (count > 0) return count;
            } else if (count < longest_bridge && turns_[e] * turns_[edge] > 0.0 &&
                       std::abs(turns_[e]) >= bridge * angle_) {
                steps.push_back({cosine, e});
            }
        }
        std::ranges::stable_sort(steps, std::greater(), &Step::cosine);
        for (const Step& step : steps) {
            way[count] = step.edge;
            if (const int edges = way_to_fold(across(vertex, step.edge), step.edge, on, way, count + 1)) return edges;
        }
        return 0;
    }

    /// What a fold's edges sum up to.
    struct Extent {
        double length = 0.0;
        Index edges = 0, concave = 0;
        bool is_marked = false;  // touches an edge that is marked sharp
    };

    /// Clears folds of one edge, and short ones, that touch no edge that is marked sharp and have too
    /// few concave edges.
    void drop_short(const std::function<bool(double)>& is_short, Array<std::uint8_t>& on) const {
        DisjointSets folds(surface_.vertex_count());
        for (Index e = 0; e < on.size(); ++e)
            if (on[e]) folds.join(surface_.edges[e].x, surface_.edges[e].y);
        Array<Extent> extent(surface_.vertex_count());
        for (Index e = 0; e < on.size(); ++e) {
            const Edge ends = surface_.edges[e];
            if (on[e]) {
                Extent& fold = extent[folds.name(ends.x)];
                fold.length += glm::distance(dvec3(surface_.positions[ends.x]), dvec3(surface_.positions[ends.y]));
                ++fold.edges;
                if (turns_[e] < 0.0) ++fold.concave;
            } else if (surface_.edge_marks[e] & mesh::mark_sharp) {
                for (const Index v : {ends.x, ends.y}) extent[folds.name(v)].is_marked = true;
            }
        }
        for (Index e = 0; e < on.size(); ++e) {
            if (!on[e]) continue;
            const Extent& fold = extent[folds.name(surface_.edges[e].x)];
            if (fold.is_marked || fold.concave >= limits_.enough_concave) continue;
            on[e] = fold.edges > 1 && !is_short(fold.length);
        }
    }

    const Surface& surface_;
    Turns turns_;
    double angle_;
    Limits limits_;
    Lists<Index> at_vertex_;  // mesh edges
};

}  // namespace

Array<std::uint8_t> find_folds(const field::FacetEdges& edges, Shape shape, double angle,
                               const std::function<bool(double)>& is_short) {
    return Folds(edges, angle, shape).find(is_short);
}

}  // namespace fovea::line
