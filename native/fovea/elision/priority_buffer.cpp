// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/priority_buffer.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/raster/tiles.h>

namespace fovea::elision {
namespace formulas {

using namespace glm;

struct Band {
#include <shared/band.glsl>
};

}  // namespace formulas

namespace {

bool cross(const PriorityTexel& a, const PriorityTexel& b) {
    return formulas::Band{}.bands_cross(vec2(a.away_x, a.away_y), vec2(b.away_x, b.away_y));
}

/// Whether no band of this rank changes the entry.
bool is_settled(const PriorityTexel& first, std::uint32_t rank) {
    return first.rank != 0 && (first.crossed || first.rank == rank);
}

/// Bands are drawn by descending rank, so the first entry stays.
void put(PriorityBuffer& buffer, std::size_t pixel, const PriorityTexel& texel) {
    PriorityTexel& first = buffer.first[pixel];
    if (first.rank == 0) {
        first = texel;
    } else if (!is_settled(first, texel.rank) && cross(first, texel)) {
        first.crossed = 1;
        buffer.second[pixel] = texel;
    }
}

void draw_triangle(const Bands& bands, Index t, const PixelBox& tile, PriorityBuffer& buffer) {
    const glm::uvec3 c = bands.triangles[t];
    const FixedTriangle shape(bands.px[c[0]], bands.px[c[1]], bands.px[c[2]]);
    const PixelBox box = intersect(shape.box(), tile);
    if (shape.empty() || box.empty()) return;
    const OverTriangle<3> across(shape, bands.across[c[0]], bands.across[c[1]], bands.across[c[2]]);
    const vec3 owner = bands.owner[c[0]];
    PriorityTexel texel{std::uint32_t(owner.z), 0, 0, 0, 0, 0};
    formulas::Band formula;
    for (int row = box.y0; row < box.y1; ++row) {
        int begin = box.x0, end = box.x1;
        shape.span(row, begin, end);
        for (int column = begin; column < end; ++column) {
            const std::size_t pixel = std::size_t(row) * buffer.width + column;
            if (is_settled(buffer.first[pixel], texel.rank)) continue;
            const vec3 place = across.at(column, row);
            texel.coverage = std::uint8_t(formula.band_coverage(place) * 255.0f + 0.5f);
            if (texel.coverage == 0) continue;
            const float away = PriorityTexel::away_unit * formula.band_side(place);
            texel.right = formula.band_ends_right(place);
            texel.away_x = int(std::lround(owner.x * away));
            texel.away_y = int(std::lround(owner.y * away));
            put(buffer, pixel, texel);
        }
    }
}

}  // namespace

PriorityBuffer draw_priorities(const Bands& bands, int width, int height, const Cancel* cancel) {
    check(width > 0 && height > 0, "priority buffer: the picture needs a positive width and height");
    PriorityBuffer buffer{width, height, {}, {}};
    buffer.first.resize(std::size_t(width) * height);
    buffer.second.resize(buffer.first.size());
    for_each_tile(bands.px, bands.triangles, width, height, [&](const PixelBox& tile, In<Index> triangles) {
        if (cancel) cancel->poll();
        for (int row = tile.y0; row < tile.y1; ++row)
            std::fill_n(&buffer.first[std::size_t(row) * width + tile.x0], tile.x1 - tile.x0, PriorityTexel{});
        for (const Index t : triangles) draw_triangle(bands, t, tile, buffer);
    });
    return buffer;
}

}  // namespace fovea::elision
