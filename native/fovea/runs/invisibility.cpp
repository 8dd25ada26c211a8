// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/invisibility.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/visibility/exact.h>
#include <fovea/visibility/occluding.h>

namespace fovea {
namespace {

constexpr std::size_t runs_per_block = 256;
/// Sets of surfaces remembered from segment to segment.
constexpr int remembered = 6;

/// Splits hidden runs.
class Splitter {
   public:
    Splitter(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const SceneBodies& bodies,
             Index levels)
        : clipped_(clipped),
          paths_(paths),
          tracer_(tracer),
          bodies_(bodies),
          levels_(static_cast<int>(std::min(levels, 255u))) {}

    void add(Index piece, double start, double end) {
        piece_ = piece;
        at_ = none;
        start_ = start;
        count_ = 0;
        const Index last = clipped_.pieces.end(piece) - 1;
        const auto arcs = clipped_.arc_px.begin();
        const auto after = std::upper_bound(arcs + clipped_.pieces.begin(piece), arcs + last, start);
        double before = start;
        for (Index i = std::max(static_cast<Index>(after - arcs), clipped_.pieces.begin(piece) + 1) - 1;
             i < last && clipped_.arc_px[i] < end; ++i) {
            const Index samples = clipped_.sample_count[i];
            const double from = clipped_.arc_px[i], step = (clipped_.arc_px[i + 1] - from) / std::max(samples, 1u);
            const auto first = static_cast<Index>(std::max(0.0, (start - from) / step - 0.5));
            for (Index j = first; j < samples && from + (j + 0.5) * step < end; ++j)
                if (from + (j + 0.5) * step > start) before = look(before, from + (j + 0.5) * step);
        }
        if (count_ == 0) look(start, 0.5 * (start + end));
        out.push(piece_, start_, end, static_cast<std::uint8_t>(count_));
    }

    Runs out;

   private:
    /// Counts at `arc`, and finds the changes since `before`.
    double look(double before, double arc) {
        const int count = count_at(arc);
        if (count_ == 0)
            count_ = count;
        else
            split(before, arc, count);
        return arc;
    }

    /// Changes of the number between two places: count_ at the first, `count` at the other.
    void split(double low, double high, int count) {
        if (count == count_) return;
        if (high - low <= exact_tolerance_px) {
            const double change = 0.5 * (low + high);
            out.push(piece_, start_, change, static_cast<std::uint8_t>(count_));
            start_ = change;
            count_ = count;
            return;
        }
        const double middle = 0.5 * (low + high);
        split(low, middle, count_at(middle));
        split(middle, high, count);
    }

    int count_at(double arc) {
        const auto arcs = clipped_.arc_px.begin();
        const Index begin = clipped_.pieces.begin(piece_), last = clipped_.pieces.end(piece_) - 1;
        if (at_ == none || arc < clipped_.arc_px[at_] || arc > clipped_.arc_px[at_ + 1]) {
            const auto after = std::upper_bound(arcs + begin + 1, arcs + last, arc);
            at_ = static_cast<Index>(after - arcs) - 1;
            segment_ = segment_at(clipped_, paths_, tracer_, piece_, at_);
            for (Enough& enough : enough_) enough.interval_known = false;
        }
        const double length = clipped_.arc_px[at_ + 1] - clipped_.arc_px[at_];
        const double s = length > 0.0 ? std::clamp((arc - clipped_.arc_px[at_]) / length, 0.0, 1.0) : 0.5;
        if (enough_at(s)) return levels_;
        tracer_.surfaces_before(vec3(segment_.at(s)), segment_.ignore, levels_, bodies_, surfaces_);
        const int count = static_cast<int>(surfaces_.size());
        if (count == levels_) remember();
        return std::max(1, count);
    }

    /// As many surfaces as are told apart, met before: no ray has to find them again where all of them hide the line.
    struct Enough {
        std::vector<Occluding> surfaces;
        Interval interval;  // on the segment of count_at
        bool interval_known = false;
    };

    bool enough_at(double s) {
        for (int i = 0; i < remembered; ++i) {
            Enough& enough = enough_[order_[i]];
            if (!enough.interval_known) enough.interval = interval_of(enough);
            enough.interval_known = true;
            if (!enough.interval.holds(s)) continue;
            if (i > 0) std::swap(order_[i], order_[i - 1]);
            return true;
        }
        return false;
    }

    Interval interval_of(const Enough& enough) const {
        if (enough.surfaces.empty()) return {};
        Interval common{0.0, 1.0};
        for (const Occluding& surface : enough.surfaces) {
            const Interval interval = surface.hides(tracer_, segment_);
            common = {std::max(common.begin, interval.begin), std::min(common.end, interval.end)};
            if (common.begin > common.end) return {};
        }
        return common;
    }

    void remember() {
        std::rotate(order_, order_ + remembered - 1, order_ + remembered);
        Enough& enough = enough_[order_[0]];
        enough.surfaces.clear();
        for (const Hit& hit : surfaces_) enough.surfaces.emplace_back(tracer_, hit);
        enough.interval_known = false;
    }

    const ClippedPaths& clipped_;
    const Paths& paths_;
    const Tracer& tracer_;
    const SceneBodies& bodies_;
    const int levels_;
    Index piece_ = 0;
    Index at_ = none;  // the segment of count_at, by its first point
    Segment segment_;
    double start_ = 0.0;  // of the run that is open
    int count_ = 0;       // its number; 0 where none was counted yet
    std::vector<Hit> surfaces_;
    Enough enough_[remembered];
    std::uint8_t order_[remembered] = {0, 1, 2, 3, 4, 5};  // of enough_, those that hid last before the others
};

}  // namespace

Runs count_invisibility(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Runs& all,
                        Index levels, const Cancel& cancel) {
    check(all.piece.empty() || all.piece.back() < clipped.path.size(), "runs: they are not of these clipped paths");
    check_same_paths(clipped, paths, "count_invisibility");
    if (levels <= 1) return all;
    tracer.check_current();
    const SceneBodies bodies = bodies_of(tracer.scene());
    std::vector<Runs> parts((all.size() + runs_per_block - 1) / runs_per_block);
    parallel_blocks(all.size(), runs_per_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
        cancel.poll();
        Splitter splitter(clipped, paths, tracer, bodies, levels);
        for (std::size_t r = begin; r < end; ++r) {
            if (all.invisibility[r] == 0)
                splitter.out.push(all.piece[r], all.start_px[r], all.end_px[r]);
            else
                splitter.add(all.piece[r], all.start_px[r], all.end_px[r]);
        }
        parts[b] = std::move(splitter.out);
    });
    Runs runs;
    for (const Runs& part : parts) runs.append(part);
    return runs;
}

}  // namespace fovea
