// SPDX-License-Identifier: GPL-3.0-or-later
// Line sets: what a style requests.
#pragma once

#include <cstdint>
#include <vector>

#include <fovea/line/registry.h>
#include <fovea/line/surfaces.h>

namespace fovea::path {

/// A definition with its parameter values.
struct LineKind {
    Index definition;  ///< index into line_definitions()
    Values values;
};

/// Per placement: the materials whose faces have lines, as indices of Surface::polygon_material.
struct MaterialFilter {
    /// Per placement: index of its mask; empty: all materials have lines.
    std::vector<Index> row = {};
    /// Per material index, 0: no lines; indices beyond the mask have lines.
    std::vector<std::vector<std::uint8_t>> masks = {};
};

/// A line set of a style: definitions with parameters, filters, and the corner angle at which paths are split.
struct LineSet {
    std::vector<LineKind> kinds;
    double corner_angle_rad = 1.0;
    std::vector<std::uint8_t> placements = {};  ///< per placement, 1: included; empty: all are
    MaterialFilter materials = {};              ///< faces of these are included
    Surfaces surfaces = Surfaces::all;

    bool is_for_all() const { return placements.empty() && materials.row.empty(); }
    /// Whether it is for all, whatever the shape of their surfaces.
    bool is_for_all_shapes() const {
        return is_for_all() && (surfaces == Surfaces::all || surfaces == Surfaces::suited);
    }
};

/// Per-placement overrides, which apply to all line sets.
struct OwnLines {
    /// Override of one parameter of a definition that depends on single surfaces.
    struct Parameter {
        Index definition, parameter;
        std::vector<double> values;  ///< per placement; NaN: no override
    };
    std::vector<Kinds> kinds = {};  ///< per placement: definitions to draw, bits as in Kinds; empty: all
    std::vector<Parameter> parameters = {};
    MaterialFilter materials = {};  ///< materials that have lines at all

    bool shows(Index placement, Index definition) const {
        return kinds.empty() || (kinds[placement] >> definition & 1);
    }
};

}  // namespace fovea::path
