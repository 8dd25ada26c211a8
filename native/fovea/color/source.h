// SPDX-License-Identifier: GPL-3.0-or-later
// Where the colors of surfaces come from.
#pragma once

#include <memory>

#include <fovea/color/texture.h>
#include <fovea/mesh/surface.h>

namespace fovea::color {

/// What a material says: its color, times an image, times an attribute of the mesh.
struct ColorSlot {
    vec3 color{0.8f};                             ///< scene-linear
    std::shared_ptr<const ColorTexture> texture;  ///< null: none
    Index uv = none;                              ///< which of the surface's uvs the texture lies on; none: not drawn
    Index attribute = none;                       ///< which of the surface's attributes
    bool unlit = false;                           ///< it shines by itself
};

/// What a surface brings along beside its geometry; corners are the mesh's own.
struct SurfaceColor {
    std::vector<ColorSlot> slots;         ///< by Surface::polygon_material; others look as the default slot
    Array<vec3> normals;                  ///< per corner, object space; empty: those of field/corner_normals.h
    std::vector<Array<vec2>> uvs;         ///< each per corner
    std::vector<Array<vec3>> attributes;  ///< each per corner, scene-linear
};

/// Of a scene: by placement; null: default slots.
using SceneColor = std::vector<std::shared_ptr<const SurfaceColor>>;

/// Throws std::invalid_argument, naming the surface, where arrays are not as long as it has corners, or a slot names
/// one that does not exist.
void check_color(const SurfaceColor& color, const Surface& surface);

}  // namespace fovea::color
