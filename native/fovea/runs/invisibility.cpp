// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/invisibility.h>

#include <algorithm>

#include <fovea/visibility/exact.h>
#include <fovea/visibility/segment.h>

namespace fovea::runs {
namespace {

/// Splits hidden runs.
class Splitter {
   public:
    Splitter(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const SceneBodies& bodies,
             Index levels, Runs& out)
        : clipped_(clipped),
          paths_(paths),
          tracer_(tracer),
          bodies_(bodies),
          out_(out),
          levels_(static_cast<int>(std::min(levels, 255u))) {}

    void add(Index piece, double start, double end) {
        piece_ = piece;
        at_ = none;
        start_ = start;
        count_ = 0;
        const Index last = clipped_.pieces.end(piece) - 1;
        double before = start;
        for (Index i = clipped_.segment_at(piece, start); i < last && clipped_.arc_px[i] < end; ++i) {
            const Index samples = clipped_.sample_count[i];
            const double from = clipped_.arc_px[i], step = (clipped_.arc_px[i + 1] - from) / std::max(samples, 1u);
            const auto first = static_cast<Index>(std::max(0.0, (start - from) / step - 0.5));
            for (Index j = first; j < samples && from + (j + 0.5) * step < end; ++j)
                if (from + (j + 0.5) * step > start) before = look(before, from + (j + 0.5) * step);
        }
        if (count_ == 0) look(start, 0.5 * (start + end));
        out_.push(piece_, start_, end, static_cast<std::uint8_t>(count_));
    }

   private:
    /// Counts surfaces at `arc`, and locates the changes since `before`.
    double look(double before, double arc) {
        const int count = count_at(arc);
        if (count_ == 0)
            count_ = count;
        else
            split(before, arc, count);
        return arc;
    }

    /// Locates changes of the count between `low`, where it is count_, and `high`, where it is `count`, by bisection.
    void split(double low, double high, int count) {
        if (count == count_) return;
        if (high - low <= exact_tolerance_px) {
            const double change = 0.5 * (low + high);
            out_.push(piece_, start_, change, static_cast<std::uint8_t>(count_));
            start_ = change;
            count_ = count;
            return;
        }
        const double middle = 0.5 * (low + high);
        split(low, middle, count_at(middle));
        split(middle, high, count);
    }

    int count_at(double arc) {
        if (at_ == none || arc < clipped_.arc_px[at_] || arc > clipped_.arc_px[at_ + 1]) {
            at_ = clipped_.segment_at(piece_, arc);
            segment_ = segment_at(clipped_, paths_, tracer_, piece_, at_);
            enough_.next_segment();
        }
        const double s = clipped_.share_at(at_, arc, 0.5);
        if (enough_.around(s, [&](const Enough& enough) { return interval_of(enough); })) return levels_;
        tracer_.surfaces_before(vec3(segment_.at(s)), segment_.ignore, levels_, bodies_, surfaces_);
        const int count = static_cast<int>(surfaces_.size());
        if (count == levels_) remember();
        return std::max(1, count);
    }

    /// A set of `levels` surfaces met before: where all of them hide the line, no ray is needed.
    using Enough = std::vector<Occluding>;

    Interval interval_of(const Enough& enough) const {
        if (enough.empty()) return {};
        Interval common = whole_segment;
        for (const Occluding& surface : enough) {
            const Interval interval = hidden_by(surface, tracer_, segment_);
            common = {std::max(common.begin, interval.begin), std::min(common.end, interval.end)};
            if (common.is_empty()) return {};
        }
        return common;
    }

    void remember() {
        Enough enough;
        for (const Hit& hit : surfaces_) enough.emplace_back(tracer_, hit);
        enough_.remember({std::move(enough), std::nullopt});
    }

    const ClippedPaths& clipped_;
    const Paths& paths_;
    const Tracer& tracer_;
    const SceneBodies& bodies_;
    Runs& out_;
    const int levels_;
    Index piece_ = 0;
    Index at_ = none;  // first point of the segment of count_at
    Segment segment_;
    double start_ = 0.0;  // start of the open run
    int count_ = 0;       // its invisibility; 0: not counted yet
    std::vector<Hit> surfaces_;
    Remembered<Enough, 6> enough_;
};

}  // namespace

Runs count_invisibility(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Runs& all,
                        Index levels, const Cancel& cancel) {
    check_runs(clipped, all);
    check_same_paths(clipped, paths, "count_invisibility");
    if (levels <= 1) return all;
    tracer.check_current();
    const SceneBodies bodies = bodies_of(tracer.scene());
    return runs_by_blocks(all.size(), runs_per_block, [&](Runs& runs, std::size_t begin, std::size_t end) {
        cancel.poll();
        Splitter splitter(clipped, paths, tracer, bodies, levels, runs);
        for (std::size_t r = begin; r < end; ++r)
            if (all.invisibility[r] == 0)
                runs.push(all, r);
            else
                splitter.add(all.piece[r], all.start_px[r], all.end_px[r]);
    });
}

}  // namespace fovea::runs
