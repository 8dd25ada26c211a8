// SPDX-License-Identifier: GPL-3.0-or-later
// Line sets restricted to one placement, with the overrides of its object applied.
#pragma once

#include <algorithm>

#include <fovea/path/line_set.h>

namespace fovea::path {

/// A line set without what a placement does not show. A line lies on the faces beside it: it is there where one of them
/// has a material of the set.
struct PlacedSet {
    std::vector<LineKind> kinds;
    double corner_angle_rad;
    std::vector<std::uint8_t> materials = {};  ///< per number, 0: without these lines; all others: with

    bool has(Index definition) const {
        return std::ranges::find(kinds, definition, &LineKind::definition) != kinds.end();
    }
    bool has_material(int number) const {
        return number < 0 || std::size_t(number) >= materials.size() || materials[number];
    }
};

/// Throws std::invalid_argument where line sets or own lines are not as many as the placements.
void check_filters(std::size_t placements, const std::vector<LineSet>& sets, const OwnLines& own);

std::vector<PlacedSet> sets_of(Index placement, const std::vector<LineSet>& sets, const OwnLines& own);

/// Every definition that a line set, or some of them, asks for.
Kinds asked_of(const PlacedSet& set);
Kinds asked_of(const std::vector<PlacedSet>& sets);

/// Whether some set has lines on faces of some materials alone.
bool any_by_material(const std::vector<PlacedSet>& sets);

inline int material_of_triangle(const Surface& surface, Index triangle) {
    return surface.material(surface.triangle_facet[triangle]);
}

/// Whether holds(material) for one of the faces beside an edge.
template <typename Holds>
bool any_beside(const Surface& surface, Index edge, const Holds& holds) {
    const auto on_side = [&](EdgeSide side) { return holds(surface.material(side.facet())); };
    return std::ranges::any_of(surface.sides(edge), on_side);
}

/// Per triangle: 1 unless holds(material).
template <typename Holds>
Array<std::uint8_t> triangles_without(const Surface& surface, const Holds& holds) {
    Array<std::uint8_t> without(surface.triangles.size());
    parallel_for(without.size(),
                 [&](std::size_t t) { without[t] = !holds(material_of_triangle(surface, static_cast<Index>(t))); });
    return without;
}

}  // namespace fovea::path
