// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/page.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/vector/text.h>
#include <fovea/vector/title_block.h>

namespace fovea::vector {
namespace {

/// Sizes of sheets of paper [mm], from Sheet::a0 on.
constexpr dvec2 sheets[] = {{841.0, 1189.0}, {594.0, 841.0}, {420.0, 594.0}, {297.0, 420.0},
                            {210.0, 297.0},  {148.0, 210.0}, {215.9, 279.4}};

}  // namespace

dvec2 sheet_size(Sheet sheet) { return sheet < Sheet::a0 ? dvec2(0.0) : sheets[int(sheet) - int(Sheet::a0)]; }

std::vector<Room> rooms_of(const dvec2& size, const Options& options) {
    const dvec2 space = size - 2.0 * options.margin;
    check(std::min(space.x, space.y) > 0.0,
          "vectors: a margin of " + number(options.margin) + " mm leaves no room on this paper: make it smaller");
    if (!options.title_block) return {{dvec2(options.margin), space}};
    const dvec2 block = title_block_size(space), left = space - block;
    std::vector<Room> rooms{{dvec2(options.margin, options.margin + block.y), {space.x, left.y}}};
    if (left.x > 0.0) rooms.push_back({dvec2(options.margin), {left.x, space.y}});
    return rooms;
}

Page page_of(const View& view, const style::Paper& paper, const Options& options) {
    const dvec2 picture(view.width, view.height);
    const double px_mm = 1.0 / paper.px_per_mm(view.reference_scale);
    check(!options.title_block || options.sheet >= Sheet::a0,
          "vectors: a title block lies on a sheet of paper: choose one, as A4, or leave the block out");
    if (options.sheet == Sheet::pixels) return {picture, dvec2(0.0), 1.0, px_mm};
    if (options.sheet == Sheet::page) return {px_mm * picture, dvec2(0.0), px_mm, 1.0};
    dvec2 size = sheet_size(options.sheet);
    if (view.width > view.height) std::swap(size.x, size.y);
    const auto largest = [&](const Room& room) { return std::min(room.size.x / picture.x, room.size.y / picture.y); };
    const std::vector<Room> rooms = rooms_of(size, options);
    const Room room = *std::ranges::max_element(rooms, {}, largest);
    const double most = largest(room), scale = options.to_scale ? px_mm : most;
    check(scale <= most * (1.0 + 1e-6), "vectors: to scale the picture is " + number(scale * picture.x) + " x " +
                                            number(scale * picture.y) + " mm, and this paper has room for " +
                                            number(room.size.x) + " x " + number(room.size.y) +
                                            " mm: take larger paper, a smaller margin or a smaller scale");
    return {size, room.lower + 0.5 * (room.size - scale * picture), scale, 1.0};
}

}  // namespace fovea::vector
