// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles touch which tile of the picture.
#pragma once

#include <fovea/image/triangle.h>

namespace fovea::image {

/// Triangles per tile, in the order in which they were given.
struct Tiles {
    static constexpr int size = 64;  // px
    int across = 0, up = 0;
    /// Triangles of tile (i, j): triangle[offsets[i + j * across] .. offsets[i + j * across + 1]].
    Array<std::size_t> offsets;
    Array<Index> triangle;
};

/// Corners in px; triangles that cover no pixel of the picture are left out.
Tiles sort_into_tiles(In<vec2> px, In<glm::uvec3> triangles, int width, int height);

}  // namespace fovea::image
