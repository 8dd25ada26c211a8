// SPDX-License-Identifier: GPL-3.0-or-later
// Color sources of surfaces.
#pragma once

#include <memory>

#include <fovea/color/texture.h>
#include <fovea/mesh/surface.h>

namespace fovea::color {

/// Color of a material: a constant, times an image, times a mesh attribute.
struct ColorSlot {
    vec3 color{0.8f};                             ///< scene-linear
    std::shared_ptr<const ColorTexture> texture;  ///< null: none
    Index uv = none;         ///< index of the surface's UV map for the texture; none: texture unused
    Index attribute = none;  ///< index of the surface's color attribute
    bool unlit = false;      ///< emission: not lit
    float opacity = 0.0f;    ///< of what does not occlude: how much of its own color it has, before what lies behind
};

/// Color data of a surface; corners are those of the mesh.
struct SurfaceColor {
    std::vector<ColorSlot> slots;         ///< by Surface::polygon_material; others use the default slot
    Array<vec3> normals;                  ///< per corner, object space; empty: those of field/corner_normals.h
    std::vector<Array<vec2>> uvs;         ///< each per corner
    std::vector<Array<vec3>> attributes;  ///< each per corner, scene-linear
};

/// Per placement of a scene; null: default slots.
using SceneColor = std::vector<std::shared_ptr<const SurfaceColor>>;

/// Throws std::invalid_argument, naming the surface, if an array does not have one entry per corner, a slot refers to
/// one that does not exist, or an opacity is not between 0 and 1.
void check_color(const SurfaceColor& color, const Surface& surface);

}  // namespace fovea::color
