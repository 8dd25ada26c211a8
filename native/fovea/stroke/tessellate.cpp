// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/tessellate.h>

#include <algorithm>
#include <limits>
#include <string>

#include <fovea/base/check.h>
#include <fovea/path/paths.h>
#include <fovea/stroke/along.h>
#include <fovea/stroke/center_line.h>
#include <fovea/stroke/emphasis.h>
#include <fovea/stroke/fade.h>
#include <fovea/stroke/hand.h>
#include <fovea/stroke/strip.h>

namespace fovea::stroke {

namespace {

constexpr std::size_t block_size = 128;  // runs
constexpr double whole_error = 1e-3;     // px: tolerance for a run that covers its whole piece
constexpr float endless = 1e9f;

void check_input(const ClippedPaths& clipped, const Runs& runs, In<Index> pen_of_run, In<float> strength,
                 In<Pen> pens) {
    const std::size_t count = runs.size();
    check(runs.start_px.size() == count && runs.end_px.size() == count && runs.invisibility.size() == count,
          "runs: piece, start_px, end_px and invisibility must have the same length");
    check(pen_of_run.size() == count, "pen_of_run: one entry per run expected");
    check(clipped.path_length_px.size() == clipped.pieces.count(), "path_length_px: one entry per piece expected");
    Index piece = 0, pen = 0;
    for (const Index q : runs.piece) piece = std::max(piece, q);
    check(runs.piece.empty() || piece < clipped.pieces.count(), "runs: there is no piece " + std::to_string(piece));
    for (const Index p : pen_of_run) pen = std::max(pen, p + 1);  // none + 1 == 0
    check(pen <= pens.size(), "pen_of_run: there is no pen " + std::to_string(pen - 1));
    for (const Pen& p : pens)
        check(p.away == none || p.away < pens.size(),
              "pen: there is no pen " + std::to_string(p.away) + " out of focus");
    if (strength.empty()) return;
    std::size_t source = 0;
    for (std::size_t i = 0; i < clipped.source.size(); ++i)
        source = std::max<std::size_t>(source, clipped.source[i] + std::size_t(clipped.source_t[i] > 0.0f));
    check(clipped.source.empty() || source < strength.size(), "strength: no entry for point " + std::to_string(source));
}

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
    check_input(clipped, runs, pen_of_run, strength, pens);
    check_emphasis(clipped, emphasis);
    check(ids.empty() || clipped.path.empty() || clipped.path.back() < ids.size(), "ids: one per path expected");
    check(visibility.empty() || visibility.size() == clipped.samples,
          "visibility: one value per atlas sample expected");
    const Array<Index> order = drawing_order(runs, pen_of_run);
    const std::vector<Modifiers> modifiers(pens.begin(), pens.end());
    auto parts =
        parallel_parts<Strokes>(order.size(), block_size, [&](Strokes& out, std::size_t begin, std::size_t end) {
            CenterLine line;
            Fade fade;
            EmphasisAlong along;
            for (std::size_t k = begin; k < end; ++k) {
                const Index r = order[k], piece = runs.piece[r], pen = pen_of_run[r];
                if (clipped.pieces.size(piece) < 2) continue;
                const double first = clipped.first_arc(piece), last = clipped.last_arc(piece);
                // Overshoot is extended straight.
                const double before = first - runs.start_px[r], after = runs.end_px[r] - last;
                find_fade(clipped, visibility, piece, std::max(runs.start_px[r], first), std::min(runs.end_px[r], last),
                          runs.invisibility[r] != 0, fade);
                const double start = fade.start_px, stop = fade.end_px;
                const bool from_first = start<first + whole_error, to_last = stop> last - whole_error;
                const bool closed = clipped.closed[piece] && from_first && to_last;
                cut(clipped, strength, piece, start, stop, line);
                if (!closed) lengthen(line, before, after);
                simplify(line);
                insert_bends(line, fade);
                find_emphasis(clipped, emphasis, piece, start, stop, along);
                emphasize(line, along);
                const Index path = clipped.path[piece];
                const style::Pen& look = pens[pen].look;
                const std::uint64_t seed = (ids.empty() ? path : ids[path]) + static_cast<Index>(look.seed);
                wobble(line, float(look.wobble), float(look.wobble_length), seed);
                const int free = clipped.free_ends[piece];
                const Index away = pens[pen].away == none ? pen : pens[pen].away;
                const PenPair pair{pens[pen], pens[away]};
                shape(line, pair, {(free & free_start) && from_first, (free & free_end) && to_last});
                press(line, float(look.pressure));
                modify(line, pair, modifiers[pen], modifiers[away], {clipped, piece, closed, seed});
                fade_ends(line, fade);
                if (line.size() < 2) continue;
                const float ends[] = {closed ? -endless : float(line.front().arc),
                                      closed ? endless : float(line.back().arc)};
                if (!closed) extend(line, look.cap);
                add_strip(line, closed, {ends[0], ends[1], float(clipped.path_length_px[piece]), pen}, out);
                out.piece.resize(out.px.size(), piece);
                ++out.count;
            }
        });
    Index count = 0;
    for (const Strokes& part : parts) count += part.count;
    Strokes all = join_strips(parts, "strokes");
    all.count = count;
    return all;
}

}  // namespace fovea::stroke
