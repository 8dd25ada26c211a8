// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/strips.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/field/turn.h>

namespace fovea::field {
namespace {

constexpr double least_turn = glm::radians(15.0), most_turn = glm::radians(65.0);
constexpr double flat = glm::radians(1.0);  // faces are looked across edges that turn less, as between triangles
constexpr double alongside = 0.9;           // cosine of the angle between the two edges

class Strips {
   public:
    explicit Strips(const Surface& surface)
        : surface_(surface), turn_(parallel_map<float>(surface.edges.size(), [&](std::size_t e) {
              return static_cast<float>(signed_turn(surface, static_cast<Index>(e)));
          })) {
        of_facet_ = lists_of<Index>(surface.facet_count(), [&](const auto& give) {
            for (Index e = 0; e < surface.edges.size(); ++e)
                for (const EdgeSide side : surface.sides(e)) give(side.facet(), e);
        });
    }

    Array<Index> find() const {
        return parallel_map<Index>(surface_.mesh_edges, [&](std::size_t e) {
            Nearest found;
            if (bends(Index(e)))
                for (const EdgeSide side : surface_.sides(Index(e))) look(Index(e), Index(e), side.facet(), 2, found);
            return found.edge;
        });
    }

   private:
    struct Nearest {
        Index edge = none;
        double width = HUGE_VAL;
    };

    bool bends(Index edge) const { return std::abs(turn_[edge]) >= least_turn && std::abs(turn_[edge]) <= most_turn; }
    dvec3 end(Index edge, int k) const { return dvec3(surface_.positions[surface_.edges[edge][k]]); }

    /// Looks for the other edge among those of a facet that was entered by the edge `from`.
    void look(Index edge, Index from, Index facet, int flats, Nearest& nearest) const {
        for (const Index other : of_facet_[facet]) {
            if (other == from) continue;
            if (std::abs(turn_[other]) < flat) {
                const In<EdgeSide> sides = surface_.sides(other);
                if (flats > 0 && sides.size() == 2)
                    look(edge, other, sides[sides[0].facet() == facet ? 1 : 0].facet(), flats - 1, nearest);
            } else if (other < surface_.mesh_edges && bends(other) && turn_[other] * turn_[edge] > 0.0f) {
                const dvec3 along = end(edge, 1) - end(edge, 0), way = end(other, 1) - end(other, 0);
                const double length = glm::length(along), size = glm::length(way);
                if (!(std::abs(glm::dot(along, way)) > alongside * length * size)) continue;
                const dvec3 from = 0.5 * (end(edge, 0) + end(edge, 1)) - end(other, 0);
                const double share = glm::dot(from, way) / (size * size);
                if (share < 0.0 || share > 1.0) continue;  // in a row with it, not alongside
                const double width = glm::distance(from, share * way);
                if (width < std::min(length, nearest.width)) nearest = {other, width};
            }
        }
    }

    const Surface& surface_;
    Array<float> turn_;
    Lists<Index> of_facet_;
};

}  // namespace

std::shared_ptr<const Array<Index>> strips_of(const Surface& surface) {
    struct Found {
        Array<Index> other;
    };
    const auto found = surface.cache().get<Found>(0, [&] {
        Array<Index> other = Strips(surface).find();
        if (std::ranges::all_of(other, [](Index edge) { return edge == none; })) other.clear();
        return Found{std::move(other)};
    });
    return {found, &found->other};
}

}  // namespace fovea::field
