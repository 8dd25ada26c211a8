// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/raster/tiles.h>

#include <fovea/base/parallel.h>

namespace fovea::raster {

namespace {

constexpr int size = 64;  // px
constexpr std::size_t blocks = 16;

/// Calls body(tile) for every tile that the triangle may touch.
template <typename Body>
void for_tiles(const FixedTriangle& triangle, const PixelBox& picture, int across, const Body& body) {
    if (triangle.empty()) return;
    const PixelBox box = intersect(triangle.box(), picture);
    if (box.empty()) return;
    const int i0 = box.x0 / size, i1 = (box.x1 - 1) / size, j0 = box.y0 / size, j1 = (box.y1 - 1) / size;
    const bool test = i0 != i1 && j0 != j1;  // a diagonal triangle misses most tiles of its box
    for (int j = j0; j <= j1; ++j)
        for (int i = i0; i <= i1; ++i)
            if (!test || triangle.may_touch({i * size, j * size, (i + 1) * size, (j + 1) * size}))
                body(std::size_t(j) * across + i);
}

}  // namespace

void for_each_tile(In<vec2> px, In<glm::uvec3> triangles, int width, int height,
                   const std::function<void(const PixelBox&, In<Index>)>& draw) {
    const int across = (width + size - 1) / size, up = (height + size - 1) / size;
    const std::size_t count = std::size_t(across) * up;
    const std::size_t block_size = triangles.size() / blocks + 1;
    const PixelBox picture{0, 0, width, height};
    const auto each = [&](const auto& body) {
        parallel_blocks(triangles.size(), block_size, [&](std::size_t block, std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t) {
                const glm::uvec3 c = triangles[t];
                for_tiles(FixedTriangle(px[c[0]], px[c[1]], px[c[2]]), picture, across,
                          [&](std::size_t tile) { body(tile * blocks + block, Index(t)); });
            }
        });
    };
    // One list per tile and block of triangles; within a tile, blocks are consecutive, so the order is kept.
    std::vector<std::size_t> next(count * blocks, 0);
    each([&](std::size_t list, Index) { ++next[list]; });
    counts_to_offsets(next);
    Array<std::size_t> offsets;
    for (std::size_t tile = 0; tile <= count; ++tile) offsets.push_back(next[tile * blocks]);
    Array<Index> members(next.back());
    each([&](std::size_t list, Index t) { members[next[list]++] = t; });
    parallel_for(count, 1, [&](std::size_t tile) {
        const int x = int(tile % across) * size, y = int(tile / across) * size;
        draw(intersect({x, y, x + size, y + size}, picture),
             In<Index>(members).subspan(offsets[tile], offsets[tile + 1] - offsets[tile]));
    });
}

}  // namespace fovea::raster
