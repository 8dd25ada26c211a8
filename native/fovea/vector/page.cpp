// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/page.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/vector/text.h>

namespace fovea::vector {
namespace {

/// Sizes of sheets of paper [mm], from Sheet::a0 on.
constexpr dvec2 sheets[] = {{841.0, 1189.0}, {594.0, 841.0}, {420.0, 594.0}, {297.0, 420.0},
                            {210.0, 297.0},  {148.0, 210.0}, {215.9, 279.4}};

}  // namespace

dvec2 sheet_size(Sheet sheet) { return sheet < Sheet::a0 ? dvec2(0.0) : sheets[int(sheet) - int(Sheet::a0)]; }

Page page_of(const View& view, const style::Paper& paper, const Options& options) {
    const dvec2 picture(view.width, view.height);
    const double px_mm = 1.0 / paper.px_per_mm(view.reference_scale);
    if (options.sheet == Sheet::pixels) return {picture, dvec2(0.0), 1.0, px_mm};
    if (options.sheet == Sheet::page) return {px_mm * picture, dvec2(0.0), px_mm, 1.0};
    dvec2 size = sheet_size(options.sheet);
    if (view.width > view.height) std::swap(size.x, size.y);
    const dvec2 room = size - 2.0 * options.margin;
    check(std::min(room.x, room.y) > 0.0,
          "vectors: a margin of " + number(options.margin) + " mm leaves no room on this paper: make it smaller");
    const double most = std::min(room.x / picture.x, room.y / picture.y), scale = options.to_scale ? px_mm : most;
    check(scale <= most * (1.0 + 1e-9), "vectors: to scale the picture is " + number(scale * picture.x) + " x " +
                                            number(scale * picture.y) + " mm, and this paper has room for " +
                                            number(room.x) + " x " + number(room.y) +
                                            " mm: take larger paper, a smaller margin or a smaller scale");
    return {size, 0.5 * (size - scale * picture), scale, 1.0};
}

}  // namespace fovea::vector
