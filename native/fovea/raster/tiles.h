// SPDX-License-Identifier: GPL-3.0-or-later
// Binning of triangles into image tiles.
#pragma once

#include <functional>

#include <fovea/raster/fixed_triangle.h>

namespace fovea::raster {

/// Calls draw(tile, members) for each tile of an image, in parallel: its pixels, and the numbers of the triangles that
/// may cover some of their centers, in input order. `px`: corners.
void for_each_tile(In<vec2> px, In<glm::uvec3> triangles, int width, int height,
                   const std::function<void(const PixelBox&, In<Index>)>& draw);

}  // namespace fovea::raster
