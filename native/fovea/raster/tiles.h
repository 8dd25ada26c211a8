// SPDX-License-Identifier: GPL-3.0-or-later
// Binning of triangles into image tiles.
#pragma once

#include <fovea/raster/fixed_triangle.h>

namespace fovea::raster {

/// Triangles per tile, in input order.
struct Tiles {
    static constexpr int size = 64;  // px
    int across = 0, up = 0;
    /// Triangles of tile (i, j): triangle[offsets[i + j * across] .. offsets[i + j * across + 1]].
    Array<std::size_t> offsets;
    Array<Index> triangle;
};

/// Corners in px; triangles that cover no pixel center of the image are dropped.
Tiles sort_into_tiles(In<vec2> px, In<glm::uvec3> triangles, int width, int height);

}  // namespace fovea::raster
