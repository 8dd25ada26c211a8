// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/tracing.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fovea/line/registry.h>
#include <fovea/stroke/octaves.h>
#include <fovea/stroke/strip.h>
#include <fovea/vector/fit.h>
#include <fovea/vector/outline.h>
#include <fovea/vector/text.h>

namespace fovea::vector {
namespace {

constexpr double outline_share = 0.5;      // of the tolerance: a stroke has two sides
constexpr double least_pattern_mm = 0.05;  // dashes and gaps that are shorter together are one line
constexpr double steps_per_repetition = 64.0, most_divisions = 1e6;  // by which ends of dividing dashes are found

bool is_sharp(const Points& points) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const dvec2 a = points[i] - points[i - 1], b = points[i + 1] - points[i];
        if (glm::dot(a, b) < stroke::mitre_limit * glm::length(a) * glm::length(b)) return true;
    }
    return false;
}

/// Whether the width is next to the same all along.
bool is_even(const Mark& mark, double tolerance) {
    const auto [low, high] = std::ranges::minmax(mark.widths);
    return high - low <= tolerance;
}

/// Takes parts of a mark, from its start on.
class Parts {
   public:
    explicit Parts(const Mark& mark) : mark_(mark) {}

    /// The dash between two lengths along it; none begins before the last one does.
    Mark dash(double from, double to) {
        while (side_ < mark_.points.size() && along_ + length_of_side(side_) <= from) along_ += length_of_side(side_++);
        Mark dash{.run = mark_.run,
                  .arc = mark_.arc + from,
                  .color = mark_.color,
                  .opacity = mark_.opacity,
                  .is_dash = true,
                  .starts = mark_.starts,
                  .ends = mark_.ends};
        double along = along_;
        for (std::size_t i = side_; i < mark_.points.size() && along < to; ++i) {
            const double step = length_of_side(i);
            if (step > 0.0) {
                if (dash.points.empty()) add(i, (from - along) / step, dash);
                add(i, (to - along) / step, dash);
            }
            along += step;
        }
        return dash;
    }

   private:
    double length_of_side(std::size_t i) const { return glm::distance(mark_.points[i - 1], mark_.points[i]); }
    void add(std::size_t i, double share, Mark& dash) const {
        const double t = std::clamp(share, 0.0, 1.0);
        dash.points.push_back(glm::mix(mark_.points[i - 1], mark_.points[i], t));
        dash.widths.push_back(glm::mix(mark_.widths[i - 1], mark_.widths[i], t));
    }

    const Mark& mark_;
    std::size_t side_ = 1;  // the first that does not end before the last dash begins
    double along_ = 0.0;    // where it begins
};

double sum(const std::vector<double>& lengths) { return std::accumulate(lengths.begin(), lengths.end(), 0.0); }

}  // namespace

Tracing::Tracing(const Frame& frame, const Options& options, const Page& page, const std::vector<Grain>& grains)
    : frame_(frame),
      inking_(frame.inking(frame.shown)),
      options_(options),
      grains_(grains),
      tolerance_(options.tolerance / page.unit_mm),
      least_pattern_(std::max({2.0 * tolerance_, least_pattern_mm / page.unit_mm, 10.0 / grid})),
      scale_(page.scale) {}

Path Tracing::path_of(const Mark& mark) const {
    const bool round = pen_of(mark).look.cap == Cap::round;
    const Look look = this->dashed(mark);
    const bool dashed = mark.is_dash || !look.dashes.empty();
    const bool as_pen_ends = mark.closed || (mark.starts && mark.ends), centered = options_.widths == Widths::center;
    const bool even = is_even(mark, outline_share * tolerance_) && (!round || as_pen_ends);
    Path path = owner_of(mark);
    if (centered || dashed || even) {
        path.look = look;
        if (!dashed) path.look.round_caps = round && (as_pen_ends || centered);
        path.look.round_joins = is_sharp(mark.points);
        path.curves = {fit(mark.points, mark.closed, tolerance_)};
    } else {
        path.curves = outline(mark.points, mark.widths, mark.closed, {round && mark.starts, round && mark.ends},
                              outline_share * tolerance_);
    }
    path.look.color = mark.color;
    path.look.opacity = mark.opacity;
    std::erase_if(path.curves, [](const Curve& curve) { return curve.empty(); });
    return path;
}

Path Tracing::owner_of(const Mark& mark) const {
    const Index piece = inking_.runs.piece[mark.run], path_number = inking_.clipped.path[piece];
    const Paths& paths = *frame_.paths;
    Path path;
    path.invisibility = inking_.runs.invisibility[mark.run];
    const Index segment = inking_.clipped.segment_at(piece, inking_.runs.start_px[mark.run]);
    const Kinds kinds = paths.kinds[inking_.clipped.source[segment]];
    const auto& definitions = line_definitions();
    for (std::size_t bit = 0; bit < definitions.size() && path.kind.empty(); ++bit)
        if (kinds >> bit & 1u) path.kind = definitions[bit]->name;
    path.object = frame_.job.overrides.object_of(paths.placement[path_number]);
    return path;
}

/// The width of a mark's line, and its dashes.
Look Tracing::dashed(const Mark& mark) const {
    const Grain& grain = grain_of(mark);
    Look look{.width = mean_width(mark)};
    look.round_caps = grain.round;
    if (grain.dashes.empty() || mark.is_dash || !mark.anchors.empty()) return look;
    // Half discs at both ends of dashes are as long as the pen is wide.
    const double repetition = scale_ * pen_of(mark).texture_length_px, cut = grain.round ? look.width : 0.0;
    for (std::size_t k = 0; k < grain.dashes.size(); ++k)
        look.dashes.push_back(std::max(repetition * grain.dashes[k] + (k % 2 ? cut : -cut), 0.0));
    // A line of less is no darker, and has no end of dashes.
    if (!(sum(look.dashes) >= least_pattern_)) {
        look.dashes.clear();
        return look;
    }
    const double into = mark.arc - repetition * grain.first - 0.5 * cut;
    look.dash_start = into - repetition * std::floor(into / repetition);
    return look;
}

/// Where dashes that are fixed to the path begin and end, in lengths along the mark.
std::vector<dvec2> Tracing::divided(const Mark& mark, const Look& look) const {
    const PenTexture& texture = grain_of(mark).dividing;
    const float repetition_px = pen_of(mark).texture_length_px;
    std::vector<dvec2> dashes;
    double along = 0.0, before = 0.0;
    for (std::size_t i = 1; i < mark.points.size(); ++i) {
        const dvec2 from = mark.anchors[i - 1], to = mark.anchors[i];
        const double side = glm::distance(mark.points[i - 1], mark.points[i]);
        const double repeats = std::abs(to.x - from.x) * std::max(from.y, to.y) / repetition_px;
        const double steps = std::clamp(std::ceil(steps_per_repetition * repeats), 1.0, most_divisions);
        for (double k = i == 1 ? 0.0 : 1.0; k <= steps; ++k) {
            const dvec2 anchor = glm::mix(from, to, k / steps);
            const double ink =
                stroke::anchored_ink(texture, float(anchor.x), 0.0f, 1.0f, float(anchor.y), repetition_px);
            // The place between the one before and this one where it is half ink.
            const double half = along + side / steps * (k - (k > 0.0 ? (ink - 0.5) / (ink - before) : 0.0));
            if (ink >= 0.5 && before < 0.5) dashes.push_back(dvec2(half));
            if (ink < 0.5 && before >= 0.5) dashes.back().y = half;
            before = ink;
        }
        along += side;
    }
    if (before >= 0.5) dashes.back().y = along;
    // Half discs at both ends of dashes are as long as the pen is wide.
    const double cut = look.round_caps ? 0.5 * look.width : 0.0;
    for (dvec2& dash : dashes) {
        if (dash.x > 0.0) dash.x += cut;
        if (dash.y < along) dash.y -= cut;
    }
    return dashes;
}

/// Where the dashes of a look begin and end along a mark of so much length; also beyond its ends.
std::vector<dvec2> Tracing::repeated(const Look& look, double length) {
    std::vector<dvec2> dashes;
    for (double at = -look.dash_start; at < length;)
        for (std::size_t k = 0; k < look.dashes.size(); at += look.dashes[k++])
            if (k % 2 == 0 && at < length && at + look.dashes[k] > 0.0) dashes.emplace_back(at, at + look.dashes[k]);
    return dashes;
}

std::vector<Mark> Tracing::dashes_of(const Mark& mark) const {
    const bool divide = !mark.anchors.empty();
    const Look look = dashed(mark);
    if (divide ? !(scale_ * pen_of(mark).texture_length_px >= least_pattern_) : look.dashes.empty()) return {mark};
    const double length = length_of(mark.points), least = 0.01 * look.width;
    Parts parts(mark);
    std::vector<Mark> dashes;
    for (const dvec2& dash : divide ? divided(mark, look) : repeated(look, length)) {
        // A dot is a dash that is next to nothing long.
        const double more = 0.5 * std::max(least - (dash.y - dash.x), 0.0);
        Mark part = parts.dash(std::max(dash.x - more, 0.0), std::min(dash.y + more, length));
        if (part.points.size() > 1) dashes.push_back(std::move(part));
    }
    return dashes;
}

}  // namespace fovea::vector
