// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/bevels.h>

#include <array>
#include <span>
#include <tuple>

#include <fovea/base/disjoint_sets.h>
#include <fovea/field/alongside.h>

namespace fovea::line {
namespace {

constexpr double least_turn = glm::radians(1.0);       // of an edge of a bevel
constexpr double least_together = glm::radians(75.0);  // by less, it may be a corner of a tube of few faces
constexpr double most_together = glm::radians(120.0);  // by more, it is a bead or the rim of a board
constexpr double beside = 2.0;                         // widths of the bevel on either side of it that are looked at
constexpr double most_beside = 0.25;                   // turn there, as a share of that of the bevel
constexpr double most_turn = (1.0 + most_beside) * most_together;  // of a bevel and what is beside it
constexpr double most_like = 0.5;           // turn of edges next to it, as a share of the mean of its own
constexpr double least_bevel_length = 5.0;  // of a bevel, in widths
constexpr int most_side_steps = 15;         // to one side

/// Edges alongside each other, across the faces between them, from one end to the other.
struct Row {
    struct Step {
        double at;    // distance from the first edge that was met, across the faces
        double turn;  // negative where it turns the other way
        Index edge;
    };
    std::array<Step, 2 * most_side_steps + 1> room;  // the first edge in the middle
    std::span<const Step> steps;                     // of it, by `at`
    double known_from = 0.0, known_to = 0.0;         // as far as its faces go
};

class Bevels {
   public:
    Bevels(const field::FacetEdges& edges, double angle)
        : surface_(edges.surface), edges_(edges), least_together_(std::max(least_together, glm::radians(angle))) {}

    Array<std::uint8_t> find(In<std::uint8_t> known) {
        const auto asked = parallel_map<std::uint8_t>(surface_.mesh_edges, [&](std::size_t e) {
            return (known.empty() || !known[e]) && std::abs(edges_.turn(Index(e))) >= least_turn &&
                   surface_.sides(Index(e)).size() == 2;
        });
        if (std::ranges::find(asked, 1) == asked.end()) return Array<std::uint8_t>(asked.size(), 0);
        steps_ = parallel_map<Step>(2 * asked.size(), [&](std::size_t i) { return step(Index(i), none); });
        const auto width =
            parallel_map<float>(asked.size(), [&](std::size_t e) { return asked[e] ? width_at(Index(e)) : 0.0f; });
        // Rows of middle edges, by the name of their vertices: length, and width weighted by length.
        DisjointSets rows(surface_.vertex_count());
        for (Index e = 0; e < width.size(); ++e)
            if (width[e] > 0.0f) rows.join(surface_.edges[e].x, surface_.edges[e].y);
        Array<dvec2> extent(surface_.vertex_count(), dvec2(0.0));
        for (Index e = 0; e < width.size(); ++e)
            if (width[e] > 0.0f) extent[rows.name(surface_.edges[e].x)] += length(e) * dvec2(1.0, width[e]);
        return parallel_map<std::uint8_t>(width.size(), [&](std::size_t e) {
            if (!(width[e] > 0.0f)) return false;
            const dvec2 of = extent[rows.name(surface_.edges[e].x)];
            return of.x * of.x >= least_bevel_length * of.y;
        });
    }

   private:
    double length(Index edge) const {
        const Edge& e = surface_.edges[edge];
        return glm::distance(dvec3(surface_.positions[e.x]), dvec3(surface_.positions[e.y]));
    }

    /// A step from an edge, across the face on a side of it, to the next edge alongside it. The sides of edge e have
    /// the numbers 2e and 2e + 1.
    struct Step {
        Index to;      // the side of the next edge on which the way goes on; none: there is none, or no face beyond it
        float turn;    // of the next edge
        double width;  // to it, or as far as the face goes
    };

    /// The step from a side of an edge to another edge than `start`.
    Step step(Index from, Index start) const {
        const Index edge = from / 2;
        const In<EdgeSide> sides = surface_.sides(edge);
        if (sides.size() <= from % 2) return {none, 0.0f, 0.0};
        const Index facet = sides[from % 2].facet();
        const auto next = edges_.across(edge, facet, [&](Index e) { return e != start; });
        if (next.edge == none || next.beyond == none) return {none, 0.0f, edges_.extent(edge, facet)};
        const bool side = surface_.sides(next.edge)[0].facet() != next.beyond;
        return {2 * next.edge + side, static_cast<float>(edges_.turn(next.edge)), next.width};
    }

    /// Width of the bevel whose middle edge it is; 0: of none.
    float width_at(Index edge) const {
        thread_local Row row;
        look_across(edge, row);
        const int count = static_cast<int>(row.steps.size());
        int at = 0;
        while (row.steps[at].edge != edge) ++at;
        // The narrowest bevel that the edge is in.
        int first = -1, last = -1;
        for (int i = 0; i <= at; ++i) {
            if (row.steps[i].turn < least_turn) continue;
            double together = 0.0;
            for (int j = i; j < count; ++j) {
                together += row.steps[j].turn;
                if (j < std::max(at, i + 1)) continue;
                const double from = row.steps[i].at, to = row.steps[j].at;  // those after j are wider
                if (first >= 0 && to - from >= row.steps[last].at - row.steps[first].at) break;
                if (!is_known_beside(row, from, to)) break;
                if (is_bevel(row, i, j, together)) first = i, last = j;
            }
        }
        if (first < 0 || row.steps[middle(row, first, last)].edge != edge) return 0.0f;
        return static_cast<float>(row.steps[last].at - row.steps[first].at);
    }

    /// Walks from an edge to both sides, to where no bevel that the edge is in has anything beside it any more: from
    /// there on it would turn by too much.
    void look_across(Index edge, Row& row) const {
        const double sign = edges_.turn(edge) < 0.0 ? -1.0 : 1.0;
        row.room[most_side_steps] = {0.0, sign * edges_.turn(edge), edge};
        int first = most_side_steps, last = most_side_steps;
        for (const int way : {-1, 1}) {
            double at = 0.0, turn = 0.0;
            Index from = 2 * edge + (way > 0);
            for (int k = 0; k < most_side_steps && turn <= most_turn; ++k) {
                Step next = steps_[from];
                if (next.to / 2 == edge) next = step(from, edge);
                at += next.width;
                if (next.to == none) break;
                row.room[way > 0 ? ++last : --first] = {way * at, sign * next.turn, next.to / 2};
                turn += std::abs(next.turn);
                from = next.to;
            }
            (way > 0 ? row.known_to : row.known_from) = way * at;
        }
        row.steps = std::span(row.room).subspan(first, last - first + 1);
    }

    /// Whether the row goes far enough on both sides of a bevel.
    static bool is_known_beside(const Row& row, double from, double to) {
        const double width = to - from;
        return from - beside * width >= row.known_from && to + beside * width <= row.known_to;
    }

    /// `together`: sum of the turns from the first to the last.
    bool is_bevel(const Row& row, int first, int last, double together) const {
        const double from = row.steps[first].at, to = row.steps[last].at, width = to - from;
        if (row.steps[first].turn < least_turn || row.steps[last].turn < least_turn) return false;
        if (!(together >= least_together_ - 1e-6 && together <= most_together)) return false;
        if (!(width > 0.0)) return false;
        double before = 0.0, after = 0.0, nearest = 0.0;  // nearest: greatest turn within a width
        for (const Row::Step& step : row.steps) {
            if (step.at < from && step.at >= from - beside * width) {
                before += std::abs(step.turn);
            } else if (step.at > to && step.at <= to + beside * width) {
                after += std::abs(step.turn);
            }
        }
        for (int k = 0; k < static_cast<int>(row.steps.size()); ++k)
            if (k < first ? row.steps[k].at >= from - width : k > last && row.steps[k].at <= to + width)
                nearest = std::max(nearest, std::abs(row.steps[k].turn));
        return before <= most_beside * together && after <= most_beside * together &&
               nearest < most_like * together / (last - first + 1);
    }

    /// The step at which half of the turn is reached, from the side that faces z more than the other one, else y or x.
    int middle(const Row& row, int first, int last) const {
        const auto facing = [&](int outer, int inner) {
            // The facet of the outer edge that is not towards the inner one.
            const In<EdgeSide> sides = surface_.sides(row.steps[outer].edge);
            const dvec3 to = centre(row.steps[inner].edge) - centre(row.steps[outer].edge);
            const dvec3 a(surface_.facet_plane[sides[0].facet()]), b(surface_.facet_plane[sides[1].facet()]);
            const double sign = edges_.turn(row.steps[outer].edge) < 0.0 ? -1.0 : 1.0;
            const dvec3 n = sign * glm::dot(a, to) < sign * glm::dot(b, to) ? a : b;
            return glm::round(64.0 * dvec3(n.z, n.y, n.x));
        };
        const dvec3 begin = facing(first, last), end = facing(last, first);
        const bool forward = std::tie(begin.x, begin.y, begin.z) >= std::tie(end.x, end.y, end.z);
        double together = 0.0, sum = 0.0;
        for (int k = first; k <= last; ++k) together += row.steps[k].turn;
        for (int k = 0; k < last - first; ++k) {
            const int step = forward ? first + k : last - k;
            sum += row.steps[step].turn;
            if (sum >= 0.5 * together - 1e-3) return step;
        }
        return forward ? last : first;
    }

    dvec3 centre(Index edge) const {
        const Edge& e = surface_.edges[edge];
        return 0.5 * (dvec3(surface_.positions[e.x]) + dvec3(surface_.positions[e.y]));
    }

    const Surface& surface_;
    field::Alongside edges_;
    double least_together_;
    Array<Step> steps_;  // from each side of each mesh edge
};

}  // namespace

Array<std::uint8_t> find_bevels(const field::FacetEdges& edges, double angle, In<std::uint8_t> known) {
    return Bevels(edges, angle).find(known);
}

}  // namespace fovea::line
