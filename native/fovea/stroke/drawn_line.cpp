// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/drawn_line.h>

#include <algorithm>
#include <string>

#include <fovea/base/check.h>
#include <fovea/stroke/anchor.h>
#include <fovea/stroke/hand.h>

namespace fovea::stroke {
namespace {

constexpr double whole_error = 1e-3;  // px: tolerance for a run that covers its whole piece

/// The pens of runs, and the places of strength.
void check_pens(const Inking& inking) {
    const auto& [clipped, runs, pen_of_run, strength, pens, visibility, emphasis, ids, paths, marks, tolerance, paints,
                 moment] = inking;
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
    check(paints.empty() || paints.size() == pens.size(), "paints: one per pen expected");
    std::size_t points = 0;
    for (std::size_t i = 0; i < clipped.source.size(); ++i)
        points = std::max<std::size_t>(points, clipped.source[i] + 1 + std::size_t(clipped.source_t[i] > 0.0f));
    const std::string missing = ": no entry for point " + std::to_string(points - 1);
    const auto check_values = [&](const auto& values, const char* name) {
        check(values.empty() || points <= values.size(), name + missing);
    };
    check_values(strength, "strength");
    for (const PenPaint& paint : paints) {
        check_values(paint.width, "paint of width");
        check_values(paint.opacity, "paint of opacity");
        check_values(paint.color, "paint of color");
    }
}

/// Leaves what is written of a line: `share` of its whole path from the start, with what goes beyond its ends.
void write(DrawnLine& drawn, double path_length_px, double share) {
    CenterLine& line = drawn.points;
    if (share >= 1.0 || line.size() < 2) return;
    const double start = std::min(line.front().arc, -0.5 * path_length_px);
    const double end = std::max(line.back().arc, 0.5 * path_length_px);
    const double written = glm::mix(start, end, share);
    if (written >= line.back().arc) return;
    drawn.closed = false;
    cut_off(line, written);
}

}  // namespace

double mark_length_px(const Pen& pen) { return pen.texture == none ? pen.look.wobble_length : pen.texture_length_px; }

void check_inking(const Inking& inking) {
    const ClippedPaths& clipped = inking.clipped;
    check_pens(inking);
    check_emphasis(clipped, inking.emphasis);
    check(inking.ids.empty() || clipped.path.empty() || clipped.path.back() < inking.ids.size(),
          "ids: one per path expected");
    check(!inking.paths || clipped.path.empty() || clipped.path.back() < inking.paths->count(),
          "paths: not those that were clipped");
    check(inking.visibility.empty() || inking.visibility.size() == clipped.samples,
          "visibility: one value per atlas sample expected");
    check(!inking.marks || !inking.marks->of || inking.marks->of->lines->rows.count() == clipped.pieces.count(),
          "marks: not those of these pieces");
}

LineShaper::LineShaper(const Inking& inking) : inking_(inking) {
    for (std::size_t i = 0; i < inking.pens.size(); ++i)
        modifiers_.emplace_back(inking.pens[i], inking.paints.empty() ? PenPaint() : inking.paints[i]);
}

bool LineShaper::shape(Index run, DrawnLine& out) const {
    const auto& [clipped, runs, pen_of_run, strength, pens, visibility, emphasis, ids, paths, marks, tolerance, paints,
                 moment] = inking_;
    CenterLine& line = out.points;
    const Index piece = runs.piece[run], pen = pen_of_run[run];
    if (clipped.pieces.size(piece) < 2) return false;
    const double first = clipped.first_arc(piece), last = clipped.last_arc(piece);
    // Overshoot is extended straight.
    const double before = first - runs.start_px[run], after = runs.end_px[run] - last;
    Fade fade;
    find_fade(clipped, visibility, piece, std::max(runs.start_px[run], first), std::min(runs.end_px[run], last),
              runs.invisibility[run] != 0, fade);
    const double start = fade.start_px, stop = fade.end_px;
    const bool from_first = start<first + whole_error, to_last = stop> last - whole_error;
    out.closed = clipped.closed[piece] && from_first && to_last;
    cut(clipped, strength, piece, start, stop, line);
    if (!out.closed) lengthen(line, before, after);
    simplify(line, tolerance);
    insert_bends(line, fade);
    EmphasisAlong along;
    find_emphasis(clipped, emphasis, piece, start, stop, along);
    emphasize(line, along);
    const Index path = clipped.path[piece];
    const style::Pen& look = pens[pen].look;
    // Paths of the view are others in each frame: marks that are handed on begin at places of their own.
    const Index away = pens[pen].away == none ? pen : pens[pen].away;
    const bool anchored = is_anchored(pens[pen]) || is_anchored(pens[away]);
    const std::uint64_t own_seed = anchored && has_marks(marks, piece) ? 0 : ids.empty() ? path : ids[path];
    const std::uint64_t seed = own_seed + static_cast<Index>(look.seed);
    const Hand hand(seed, moment.boil, moment.boil_drawing);
    if (anchored) PathAnchor(clipped, paths, marks, piece, mark_length_px(pens[pen])).place(line);
    wobble(line, float(look.wobble), float(look.wobble_length), hand);
    const int free = clipped.free_ends[piece];
    const PenPair pair{pens[pen], pens[away]};
    stroke::shape(line, pair, {(free & free_start) && from_first, (free & free_end) && to_last});
    press(line, float(look.pressure));
    const Course course{clipped, piece, out.closed, hand};
    modify(line, pair, modifiers_[pen], modifiers_[away], course);
    fade_ends(line, fade);
    if (runs.invisibility[run] == 0 && !along.seen.empty()) vanish(line, moment.vanish, pens[pen], hand);
    color(line, modifiers_[pen], modifiers_[away], course);
    write(out, clipped.path_length_px[piece], moment.written * look.written);
    return line.size() >= 2;
}

}  // namespace fovea::stroke
