// SPDX-License-Identifier: GPL-3.0-or-later
// What an artist has said of a scene's placements, beside what they look like.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fovea/color/texture.h>
#include <fovea/path/line_set.h>
#include <fovea/path/painted.h>

namespace fovea::draw {

/// Per placement where nothing else is said; empty arrays: nothing is said of any.
struct Overrides {
    /// Priority in elision, in [0, 1]. Borrowed.
    In<float> importance;
    /// Values painted on meshes, by the name of the attribute. Borrowed.
    std::map<std::string, Painted> painted;
    /// Names of the object, and of what made an instance of it.
    std::vector<std::vector<std::string>> objects;
    /// How dense lines may be, over the camera's frame; null: as their pens say.
    std::shared_ptr<const ColorTexture> density_map;
    /// Which lines placements have of their own, and on which materials.
    OwnLines lines;

    /// Whose lines a line set has, as in LineSet; by set. Empty: all lines of all placements.
    struct Filter {
        std::vector<std::uint8_t> placements;
        MaterialFilter materials;
    };
    std::vector<Filter> line_sets;

    /// What is painted by that name; empty on every placement where nothing is.
    Painted painted_as(const std::string& attribute, std::size_t placements) const {
        const auto found = painted.find(attribute);
        return found == painted.end() ? Painted(placements) : found->second;
    }
};

}  // namespace fovea::draw
