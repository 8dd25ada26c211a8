// SPDX-License-Identifier: GPL-3.0-or-later
// What a style asks for.
#pragma once

#include <cstdint>
#include <vector>

#include <fovea/line/registry.h>

namespace fovea::path {

/// A definition with its parameters.
struct LineKind {
    Index definition;  ///< index into line_definitions()
    Values values;
};

/// Of each placement, which materials have lines, by their number in Surface::polygon_material.
struct MaterialFilter {
    std::vector<Index> row = {};                        ///< per placement: its mask; empty: all materials have lines
    std::vector<std::vector<std::uint8_t>> masks = {};  ///< per number, 0: it has no lines; all others have
};

/// One of a style's line sets: which definitions with which parameters, of what, and where paths split.
struct LineSet {
    std::vector<LineKind> kinds;
    double corner_angle_rad = 1.0;
    std::vector<std::uint8_t> placements = {};  ///< of the scene, 1: its lines are for this set; empty: all are
    MaterialFilter materials = {};              ///< lines on faces of these are for this set

    bool is_for_all() const { return placements.empty() && materials.row.empty(); }
};

/// What placements have of their own, whatever the line sets say.
struct OwnLines {
    /// Of a definition that looks at one surface.
    struct Parameter {
        Index definition, parameter;
        std::vector<double> values;  ///< per placement; NaN: as the line set says
    };
    std::vector<Kinds> kinds = {};  ///< per placement: definitions that it shows, bits as in Kinds; empty: all
    std::vector<Parameter> parameters = {};
    MaterialFilter materials = {};  ///< those that have lines at all

    bool shows(Index placement, Index definition) const {
        return kinds.empty() || (kinds[placement] >> definition & 1);
    }
};

}  // namespace fovea::path
