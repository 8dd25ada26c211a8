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
#include <shared/precedence.glsl>
};

}  // namespace formulas

namespace {

/// Which lines are passing others: per rank, the precedence and whether it changes; both may be empty.
struct Passing {
    In<vec3> precedence;
    Array<std::uint8_t> changing = changing_ranks(precedence);
};

/// Whether a band shows to others where it lies under another one.
bool shows_under(const PriorityTexel& first, const PriorityTexel& other, const Passing& passing) {
    formulas::Band formula;
    if (formula.bands_cross(vec2(first.away_x, first.away_y), vec2(other.away_x, other.away_y))) return true;
    return !passing.changing.empty() && (passing.changing[first.rank] || passing.changing[other.rank]) &&
           formula.is_passing(passing.precedence[first.rank], passing.precedence[other.rank]);
}

/// Whether no band of this rank changes the entry.
bool is_settled(const PriorityTexel& first, std::uint32_t rank) {
    return first.rank != 0 && (first.crossed || first.rank == rank);
}

/// Bands are drawn by descending rank, so the first entry stays.
void put(PriorityBuffer& buffer, std::size_t pixel, const PriorityTexel& texel, const Passing& passing) {
    PriorityTexel& first = buffer.first[pixel];
    if (first.rank == 0) {
        first = texel;
    } else if (!is_settled(first, texel.rank) && shows_under(first, texel, passing)) {
        first.crossed = 1;
        buffer.second[pixel] = texel;
    }
}

void draw_triangle(const Bands& bands, Index t, const PixelBox& tile, const Passing& passing, PriorityBuffer& buffer) {
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
            put(buffer, pixel, texel, passing);
        }
    }
}

}  // namespace

Array<std::uint8_t> changing_ranks(In<vec3> precedence_of_rank) {
    return parallel_map<std::uint8_t>(precedence_of_rank.size(), [&](std::size_t rank) {
        return precedence_of_rank[rank].x != precedence_of_rank[rank].y;
    });
}

PriorityBuffer draw_priorities(const Bands& bands, int width, int height, In<vec3> precedence_of_rank,
                               const Cancel* cancel) {
    check(width > 0 && height > 0, "priority buffer: the picture needs a positive width and height");
    const Passing passing{precedence_of_rank};
    PriorityBuffer buffer{width, height, {}, {}};
    buffer.first.resize(std::size_t(width) * height);
    buffer.second.resize(buffer.first.size());
    for_each_tile(bands.px, bands.triangles, width, height, [&](const PixelBox& tile, In<Index> triangles) {
        if (cancel) cancel->poll();
        for (int row = tile.y0; row < tile.y1; ++row)
            std::fill_n(&buffer.first[std::size_t(row) * width + tile.x0], tile.x1 - tile.x0, PriorityTexel{});
        for (const Index t : triangles) draw_triangle(bands, t, tile, passing, buffer);
    });
    return buffer;
}

}  // namespace fovea::elision
