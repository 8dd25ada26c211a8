// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/bands.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <fovea/base/check.h>
#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>

namespace fovea::elision {
namespace {

constexpr std::size_t runs_per_block = 64;
constexpr double width_error_px = 0.05;
constexpr double pulled_back = 0.25;  // share of half the width by which bands are shortened at their ends
constexpr Index most_ranks = (Index(1) << 23) - 1;

/// Runs of more than `crowd` ranks that are alike are one: only so many bands are drawn, of the highest ranks. Two
/// would do (a pixel keeps the first band and one that crosses it) if bands that are alike were the same to the bit.
constexpr std::size_t crowd = 16;
constexpr float alike_px = 0.0625f;

/// Half width at an arc length.
struct Knot {
    double arc, half;
};

/// Drops knots between which the width is linear, within the tolerance, in one pass: the slopes from a knot that pass
/// all following ones within the tolerance form a cone, which narrows until it misses one (Sklansky & Gonzalez 1980).
void simplify(std::vector<Knot>& knots) {
    if (knots.size() < 3) return;
    constexpr double any = std::numeric_limits<double>::infinity();
    std::size_t kept = 0;
    double least = -any, most = any;
    for (std::size_t k = 1; k < knots.size(); ++k) {
        const Knot from = knots[kept], here = knots[k];
        const double run = here.arc - from.arc;
        const double slope = (here.half - from.half) / run;
        if (!(slope >= least && slope <= most)) {
            knots[++kept] = knots[k - 1];
            const double next_run = here.arc - knots[kept].arc, rise = here.half - knots[kept].half;
            least = (rise - width_error_px) / next_run;
            most = (rise + width_error_px) / next_run;
            continue;
        }
        least = std::max(least, (here.half - width_error_px - from.half) / run);
        most = std::min(most, (here.half + width_error_px - from.half) / run);
    }
    knots[++kept] = knots.back();
    knots.resize(kept + 1);
}

class Band {
   public:
    Band(const ClippedPaths& clipped, const Runs& runs, In<Index> ranks, const OwnBands& own, Bands& out)
        : clipped_(clipped), runs_(runs), ranks_(ranks), own_(own), out_(out) {}

    void add(std::size_t run) {
        const Index piece = runs_.piece[run];
        start_ = runs_.start_px[run];
        end_ = runs_.end_px[run];
        rank_ = float(ranks_[run]);
        find_knots(Index(run));
        if (knots_.empty()) return;
        run_start_ = start_;
        run_end_ = end_;
        reach_ = std::max(1e-6, std::min(double(own_.reach_px), 0.5 * (end_ - start_)));
        move_ends(own_.dot.empty() ? 0.0 : own_.dot[run]);
        knot_ = 0;
        has_before_ = false;
        const Index last = clipped_.pieces.end(piece) - 1, first = clipped_.segment_at(piece, run_start_);
        for (Index i = first; i < last && clipped_.arc_px[i] < run_end_; ++i) {
            const bool ends = i + 1 == last || clipped_.arc_px[i + 1] >= run_end_;
            add_segment(i, i == first ? start_ : std::max(start_, clipped_.arc_px[i]),
                        ends ? end_ : std::min(end_, clipped_.arc_px[i + 1]));
        }
    }

   private:
    void find_knots(Index run) {
        knots_.clear();
        for (Index s = own_.runs.begin(run); s < own_.runs.end(run); ++s) {
            const double arc = start_ + own_.band[s].z;
            if (knots_.empty() || arc > knots_.back().arc) knots_.push_back({arc, own_.band[s].x});
        }
        simplify(knots_);
    }

    /// Shortens the band at both ends, so that bands of lines that continue each other do not overlap, even if slightly
    /// misaligned; that of a dot goes on by half its width.
    void move_ends(double dot) {
        const double most = (end_ - start_) * 0.25;
        const auto shorter = [&](double half) { return glm::mix(std::min(most, pulled_back * half), -half, dot); };
        start_ += shorter(knots_.front().half);
        end_ -= shorter(knots_.back().half);
    }

    /// Half width at an arc length; calls must be in ascending order.
    double half_at(double arc) {
        while (knot_ + 1 < knots_.size() && knots_[knot_ + 1].arc <= arc) ++knot_;
        const Knot& a = knots_[knot_];
        if (knot_ + 1 == knots_.size() || arc <= a.arc) return a.half;
        const Knot& b = knots_[knot_ + 1];
        return glm::mix(a.half, b.half, (arc - a.arc) / (b.arc - a.arc));
    }

    double near_end(double arc) const {
        const auto near = [&](double px) { return std::clamp(1.0 - px / reach_, 0.0, 1.0); };
        return near(run_end_ - arc) - near(arc - run_start_);
    }

    /// The next arc length, at most `last`, at which width or distance to an end stops being linear.
    double next_bend(double arc, double last) const {
        double next = last;
        if (knot_ + 1 < knots_.size()) next = std::min(next, std::max(knots_[knot_ + 1].arc, arc));
        for (const double bend : {run_start_, run_start_ + reach_, run_end_ - reach_, run_end_})
            if (bend > arc) next = std::min(next, bend);
        return next > arc ? next : last;
    }

    /// The part of the band along segment i between two arc lengths, which may lie beyond the segment.
    void add_segment(Index i, double from, double to) {
        const dvec2 p = clipped_.px[i], way = dvec2(clipped_.px[i + 1]) - p;
        const double length = glm::length(way), arcs = clipped_.arc_px[i + 1] - clipped_.arc_px[i];
        if (!(to > from) || !(length > 0.0)) return;
        const auto place = [&](double arc) { return p + way * ((arc - clipped_.arc_px[i]) / arcs); };
        const dvec2 left = dvec2(-way.y, way.x) / length;
        double arc = from;
        Side side{half_at(arc), near_end(arc)};
        if (has_before_) fill_bend(place(arc), left, side);
        while (arc < to) {
            const double begin = arc;
            const Side before = side;
            arc = next_bend(arc, to);
            side = {half_at(arc), near_end(arc)};
            add_quad(place(begin), place(arc), before, side, left);
        }
        left_before_ = left;
        has_before_ = true;
    }

    /// Cross section of a band at an arc length.
    struct Side {
        double half, near_end;
    };

    void corner(const dvec2& px, double v, const Side& side, const dvec2& left) const {
        out_.px.push_back(vec2(px));
        out_.across.push_back(vec3(v, side.half, side.near_end));
        out_.owner.push_back(vec3(left, rank_));
    }

    void add_quad(const dvec2& a, const dvec2& b, const Side& at_a, const Side& at_b, const dvec2& left) const {
        const Index base = Index(out_.px.size());
        for (const double side : {1.0, -1.0}) {
            corner(a + left * (side * (at_a.half + 0.5)), side * (at_a.half + 0.5), at_a, left);
            corner(b + left * (side * (at_b.half + 0.5)), side * (at_b.half + 0.5), at_b, left);
        }
        out_.triangles.push_back({base, base + 1, base + 2});
        out_.triangles.push_back({base + 2, base + 1, base + 3});
    }

    void fill_bend(const dvec2& at, const dvec2& left, const Side& here) const {
        const double turn = cross(left_before_, left), reach = here.half + 0.5;
        if (std::abs(turn) * reach < 0.25 || glm::dot(left, left_before_) < -0.99) return;
        const double side = turn > 0.0 ? -1.0 : 1.0;
        const dvec2 middle = glm::normalize(left + left_before_);
        const Index base = Index(out_.px.size());
        corner(at, 0.0, here, middle);
        corner(at + left_before_ * (side * reach), side * reach, here, middle);
        corner(at + left * (side * reach), side * reach, here, middle);
        out_.triangles.push_back({base, base + 1, base + 2});
    }

    const ClippedPaths& clipped_;
    const Runs& runs_;
    In<Index> ranks_;
    const OwnBands& own_;
    Bands& out_;
    double start_ = 0.0, end_ = 0.0;          // of the band
    double run_start_ = 0.0, run_end_ = 0.0;  // of the run
    double reach_ = 0.0;
    float rank_ = 0.0f;
    std::vector<Knot> knots_;
    std::size_t knot_ = 0;
    dvec2 left_before_{0.0};
    bool has_before_ = false;
};

/// Hash of the place and the widths of a run's band, rounded.
std::uint64_t hash_of_band(const ClippedPaths& clipped, const Runs& runs, const OwnBands& own, Index run) {
    const auto rounded = [](float px) { return std::int64_t(std::llround(px / alike_px)); };
    const Index piece = runs.piece[run], last = clipped.pieces.end(piece) - 1;
    std::uint64_t hash = hash_numbers(rounded(float(runs.end_px[run] - runs.start_px[run])), own.runs.size(run),
                                      rounded(own.dot.empty() ? 0.0f : own.dot[run]));
    const auto add = [&](const vec2& px) { hash = hash_numbers(hash, rounded(px.x), rounded(px.y)); };
    add(clipped.place_px(piece, runs.start_px[run]));
    for (Index i = clipped.segment_at(piece, runs.start_px[run]) + 1; i < last && clipped.arc_px[i] < runs.end_px[run];
         ++i)
        add(clipped.px[i]);
    add(clipped.place_px(piece, runs.end_px[run]));
    for (Index s = own.runs.begin(run); s < own.runs.end(run); ++s) hash = hash_numbers(hash, rounded(own.band[s].x));
    return hash;
}

/// Runs with samples by descending rank, without those of bands that are drawn often enough.
std::vector<Index> runs_to_draw(const ClippedPaths& clipped, const Runs& runs, In<Index> ranks, const OwnBands& own) {
    struct Candidate {
        std::uint64_t band;
        Index above, run;  // runs of higher ranks come first
        auto order() const { return std::tuple(band, above, run); }
    };
    auto candidates = parallel_map<Candidate>(runs.size(), [&](std::size_t r) -> Candidate {
        return {own.runs.size(Index(r)) > 0 ? hash_of_band(clipped, runs, own, Index(r)) : 0, most_ranks - ranks[r],
                Index(r)};
    });
    parallel_sort(candidates.begin(), candidates.end(),
                  [](const Candidate& a, const Candidate& b) { return a.order() < b.order(); });
    Array<Candidate> chosen;
    std::size_t alike = 0;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const bool again = k > 0 && candidates[k].band == candidates[k - 1].band;
        alike = again ? alike + (candidates[k].above != candidates[k - 1].above) : 1;
        if (alike <= crowd && own.runs.size(candidates[k].run) > 0) chosen.push_back(candidates[k]);
    }
    parallel_sort(chosen.begin(), chosen.end(), [](const Candidate& a, const Candidate& b) {
        return std::pair(a.above, a.run) < std::pair(b.above, b.run);
    });
    std::vector<Index> order(chosen.size());
    std::ranges::transform(chosen, order.begin(), &Candidate::run);
    return order;
}

}  // namespace

Bands draw_bands(const ClippedPaths& clipped, const Runs& runs, In<Index> ranks, const OwnBands& own) {
    check_runs(clipped, runs);
    check(ranks.size() == runs.size() && own.runs.count() == runs.size(), "elision: ranks or samples of other runs");
    check(ranks.empty() || std::ranges::max(ranks) <= most_ranks,
          "elision: too many paths; 8 million can be told apart");
    const std::vector<Index> order = runs_to_draw(clipped, runs, ranks, own);
    auto parts =
        parallel_parts<Bands>(order.size(), runs_per_block, [&](Bands& part, std::size_t begin, std::size_t end) {
            Band band(clipped, runs, ranks, own, part);
            for (std::size_t k = begin; k < end; ++k) band.add(order[k]);
        });
    return join_strips(parts, "elision");
}

}  // namespace fovea::elision
