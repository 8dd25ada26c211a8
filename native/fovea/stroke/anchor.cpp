// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/anchor.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/view.h>
#include <fovea/stroke/fragment.h>

namespace fovea::stroke {
namespace {

constexpr double bent_px = 4.0;  // between points in which places are exact, as perspective bends them
constexpr double least_scale = 1.0 / 64.0, most_scale = 64.0;  // of marks that are crushed or drawn out

double noise_of_seed(const CenterPoint& point, double length_px, std::uint64_t seed) {
    if (!(point.whole_px > 0.0)) return two_octaves(point.arc / length_px, seed);
    const vec2 octave = formulas::Stroke{}.stroke_octave(float(point.whole_px), float(length_px));
    const auto at = [&](double place) {
        const double along = place * octave.x;
        return mixed_noises(two_octaves(0.5 * along, seed), two_octaves(along, seed), octave.y);
    };
    const double own = at(point.noise_along);
    return point.next > 0.0 ? mixed_noises(own, at(point.next_along), point.next) : own;
}

}  // namespace

PathAnchor::PathAnchor(const ClippedPaths& clipped, const Paths* paths, const Marks* marks, Index piece,
                       double window_px)
    : clipped_(clipped),
      paths_(paths),
      marks_(has_marks(marks, piece) ? marks : nullptr),
      piece_(piece),
      window_px_(window_px) {
    const Index path = clipped.path[piece];
    if (paths_ && !paths_->of_view[path]) rest_length_ = paths_->arc_obj[paths_->rows.end(path) - 1];
    if (!(rest_length_ > 0.0)) paths_ = nullptr;
}

void PathAnchor::place(CenterLine& line) const {
    if (line.size() < 2) return;
    if (paths_ || marks_) insert_points(line, multiples(line, bent_px));
    for (CenterPoint& p : line) place(p);
}

/// Arc length in the rest shape, from the start of the path, at one in the image inside the piece.
double PathAnchor::rest_at(double arc) const {
    const Index i = clipped_.segment_at(piece_, arc), from = clipped_.source[i];
    const double share = clipped_.in_space(i, clipped_.share_at(i, arc));
    const double begin = clipped_.source_t[i], end = clipped_.source[i + 1] == from ? clipped_.source_t[i + 1] : 1.0;
    return glm::mix(paths_->arc_obj[from], paths_->arc_obj[from + 1], glm::mix(begin, end, share));
}

void PathAnchor::place(CenterPoint& point) const {
    const double whole_px = std::max(clipped_.path_length_px[piece_], 1.0);
    point.whole_px = whole_px;
    point.along = point.arc / whole_px;
    if (marks_) return place_at_marks(point);
    if (paths_) place_at_rest(point);
    point.noise_along = point.along;
}

void PathAnchor::place_at_rest(CenterPoint& point) const {
    const double first = clipped_.first_arc(piece_), last = clipped_.last_arc(piece_);
    const double inside = std::clamp(point.arc, first, last);
    const double low = std::max(inside - 0.5 * window_px_, first), high = std::min(inside + 0.5 * window_px_, last);
    const double rest = rest_at(high) - rest_at(low);
    if (rest > 0.0) point.whole_px = (high - low) / rest * rest_length_;
    // Beyond the ends of its piece a line goes on as long as it was in the image.
    point.along = rest_at(inside) / rest_length_ - 0.5 + (point.arc - inside) / point.whole_px;
}

/// A value of the places of marks at an arc length; beyond the ends of its piece as at these.
double PathAnchor::mark_at(In<double> values, double arc) const {
    const ViewLines& lines = *marks_->of->lines;
    const double number = lines.number_at(piece_, arc);
    const Index before = std::min(Index(number), lines.rows.size(piece_) - 2), at = lines.rows.begin(piece_) + before;
    return glm::mix(values[at], values[at + 1], number - before);
}

void PathAnchor::place_at_marks(CenterPoint& point) const {
    const double first = clipped_.first_arc(piece_), last = clipped_.last_arc(piece_);
    const double inside = std::clamp(point.arc, first, last), period = marks_->of->period[piece_];
    const double low = std::max(inside - 0.5 * window_px_, first), high = std::min(inside + 0.5 * window_px_, last);
    const double marked = mark_at(marks_->last, high) - mark_at(marks_->last, low);
    point.way = marked < 0.0 ? -1.0 : 1.0;
    point.whole_px = period * std::clamp((high - low) / std::max(std::abs(marked), 1e-9), least_scale, most_scale);
    const double beyond = point.way * (point.arc - inside) / point.whole_px;
    point.along = mark_at(marks_->at, inside) / period + beyond;
    point.noise_along = mark_at(marks_->last, inside) / period + beyond;
    if (!(marks_->share > 0.0)) return;
    point.next = marks_->share;
    point.next_along = mark_at(marks_->next, inside) / period + beyond;
}

double noise_along(const CenterPoint& point, double length_px, const Hand& hand) {
    const double own = noise_of_seed(point, length_px, hand.own);
    return hand.boil > 0.0 ? mixed_noises(own, noise_of_seed(point, length_px, hand.other), hand.boil) : own;
}

}  // namespace fovea::stroke
