// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/tessellate.h>

#include <algorithm>
#include <limits>

#include <fovea/stroke/drawn_line.h>
#include <fovea/stroke/strip.h>

namespace fovea::stroke {

namespace {

constexpr std::size_t block_size = 128;  // runs
constexpr float endless = 1e9f;

/// The runs that have a pen, by descending invisibility; stable (counting sort).
Array<Index> drawing_order(const Runs& runs, In<Index> pen_of_run) {
    constexpr int most = std::numeric_limits<std::uint8_t>::max();
    const auto each = [&](const auto& give) {
        for (std::size_t r = 0; r < runs.size(); ++r)
            if (pen_of_run[r] != none) give(most - runs.invisibility[r], Index(r));
    };
    return lists_of<Index>(most + 1, each).values;
}

}  // namespace

Strokes tessellate(const ClippedPaths& clipped, const Runs& runs, In<Index> pen_of_run, In<float> strength,
                   In<Pen> pens, In<float> visibility, const Emphasis& emphasis, In<std::uint64_t> ids) {
    return tessellate({clipped, runs, pen_of_run, strength, pens, visibility, emphasis, ids});
}

Strokes tessellate(const Inking& inking) {
    check_inking(inking);
    const Array<Index> order = drawing_order(inking.runs, inking.pen_of_run);
    const LineShaper shaper(inking);
    const bool colored = std::ranges::any_of(inking.paints, [](const PenPaint& p) { return !p.color.empty(); });
    auto parts =
        parallel_parts<Strokes>(order.size(), block_size, [&](Strokes& out, std::size_t begin, std::size_t end) {
            DrawnLine drawn;
            CenterLine& line = drawn.points;
            for (std::size_t k = begin; k < end; ++k) {
                if (!shaper.shape(order[k], drawn)) continue;
                const Index piece = inking.runs.piece[order[k]], pen = inking.pen_of_run[order[k]];
                const float ends[] = {drawn.closed ? -endless : float(line.front().arc),
                                      drawn.closed ? endless : float(line.back().arc)};
                if (!drawn.closed) extend(line, inking.pens[pen].look.cap);
                add_strip(line, drawn.closed, {ends[0], ends[1], pen, colored}, out);
                out.piece.resize(out.px.size(), piece);
                ++out.count;
            }
        });
    Index count = 0;
    for (const Strokes& part : parts) count += part.count;
    Strokes all = join_strips(parts, "strokes");
    all.count = count;
    if (!colored) all.color = {};
    return all;
}

}  // namespace fovea::stroke
