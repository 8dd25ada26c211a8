// SPDX-License-Identifier: GPL-3.0-or-later
// Per-placement overrides.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fovea/color/texture.h>
#include <fovea/path/line_set.h>
#include <fovea/path/painted.h>
#include <fovea/style/paint.h>

namespace fovea::draw {

/// Per placement unless stated otherwise; empty arrays: no overrides.
struct Overrides {
    /// Priority in elision, in [0, 1]. Borrowed.
    In<float> importance;
    /// What is painted, as numbers and as colors. Those of materials are per material, those of objects per surface,
    /// others per corner (PaintedOn). Borrowed.
    std::map<style::Paint, Painted> painted;
    std::map<style::Paint, PaintedColors> painted_colors;
    /// Not per placement: lists of names, of an object and of what instanced it.
    std::vector<std::vector<std::string>> objects;
    /// The name of each of these objects alone, for mattes; empty: nothing has a name.
    std::vector<std::string> names;
    /// The list of each placement. Borrowed.
    In<Index> objects_of_placement;
    /// Density map over the camera's frame; null: the pens' spacing.
    std::shared_ptr<const ColorTexture> density_map;
    /// Per-placement overrides of line definitions, and their material filters.
    OwnLines lines;

    /// Placement and material filter of a line set, as in LineSet. `line_sets`: one per set; empty: all lines of all
    /// placements.
    struct Filter {
        std::vector<std::uint8_t> placements;
        MaterialFilter materials;
    };
    std::vector<Filter> line_sets;

    /// The name of a placement's object; empty: nothing has one.
    std::string object_of(Index placement) const {
        if (placement >= objects_of_placement.size()) return {};
        const auto& list = objects[objects_of_placement[placement]];
        return list.empty() ? std::string() : list.front();
    }
};

}  // namespace fovea::draw
