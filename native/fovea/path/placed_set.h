// SPDX-License-Identifier: GPL-3.0-or-later
// Line sets restricted to one placement, with the overrides of its object applied.
#pragma once

#include <algorithm>

#include <fovea/path/line_set.h>

namespace fovea::path {

/// A line set without the definitions that a placement does not show. A line at several faces is included if one of
/// them has a material of the set.
struct PlacedSet {
    std::vector<LineKind> kinds;
    double corner_angle_rad;
    std::vector<std::uint8_t> materials = {};  ///< per material index, 0: no lines; indices beyond it have lines

    bool has(Index definition) const {
        return std::ranges::find(kinds, definition, &LineKind::definition) != kinds.end();
    }
    bool has_material(int number) const {
        return number < 0 || std::size_t(number) >= materials.size() || materials[number];
    }
};

/// Throws std::invalid_argument if arrays per placement in line sets or overrides do not have `placements` entries, or
/// if a material filter refers to a missing mask.
void check_filters(std::size_t placements, const std::vector<LineSet>& sets, const OwnLines& own);

/// Whether sets_of depends on the placement itself, not on its surface alone.
bool varies_by_placement(const std::vector<LineSet>& sets, const OwnLines& own);

/// `surface`: the placement's.
std::vector<PlacedSet> sets_of(Index placement, const Surface& surface, const std::vector<LineSet>& sets,
                               const OwnLines& own);

/// Bits of all definitions that a line set, or any of several, requests.
Kinds asked_of(const PlacedSet& set);
Kinds asked_of(const std::vector<PlacedSet>& sets);

/// Whether some set is restricted to faces of certain materials.
bool any_by_material(const std::vector<PlacedSet>& sets);

inline int material_of_triangle(const Surface& surface, Index triangle) {
    return surface.material(surface.triangle_facet[triangle]);
}

/// Whether holds(material) is true for one of the faces at an edge; for a loose edge, of the first material.
template <typename Holds>
bool any_beside(const Surface& surface, Index edge, const Holds& holds) {
    const auto on_side = [&](EdgeSide side) { return holds(surface.material(side.facet())); };
    return surface.is_loose(edge) ? holds(0) : std::ranges::any_of(surface.sides(edge), on_side);
}

/// Per triangle: 1 unless holds(material) is true.
template <typename Holds>
Array<std::uint8_t> triangles_without(const Surface& surface, const Holds& holds) {
    return parallel_map<std::uint8_t>(surface.triangles.size(), [&](std::size_t t) {
        return !holds(material_of_triangle(surface, static_cast<Index>(t)));
    });
}

}  // namespace fovea::path
