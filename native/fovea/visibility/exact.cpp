// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/exact.h>

#include <algorithm>
#include <cmath>

#include <fovea/visibility/occluding.h>

namespace fovea {
namespace {

constexpr std::size_t pieces_per_block = 256;

/// Visibility along segments, one after the other, remembering what hid the last ones.
class Marcher {
   public:
    explicit Marcher(const Tracer& tracer) : tracer_(tracer) {}

    /// Appends the hidden intervals of a segment with `samples` samples, in screen fractions, ascending and disjoint.
    void march(const Segment& segment, Index samples, double length_px, std::vector<Interval>& hidden) {
        segment_ = &segment;
        known_.next_segment();
        const double step = 1.0 / samples, tolerance = exact_tolerance_px / std::max(length_px, 1e-9);
        double seen = 0.0;  // visible here (or the beginning)
        bool was_hidden = false;
        for (Index i = 0; i < samples; ++i) {
            const double s = (i + 0.5) * step;
            if (was_hidden && hidden.back().end >= s) {
                i = std::max(i, static_cast<Index>(std::min(hidden.back().end * samples - 0.5, samples - 1.0)));
                continue;
            }
            const Interval by = hidden_at(s);
            if (by.begin > by.end) {
                if (was_hidden) hidden.back().end = narrow(hidden.back().end, s, 1.0, tolerance);
                was_hidden = false;
                seen = s;
            } else if (was_hidden) {
                // Less than a sample between two shadows: no line is seen through it.
                hidden.back().end = std::max(hidden.back().end, by.end);
            } else {
                const double begin = narrow(by.begin, seen, -1.0, tolerance);
                // At the very beginning of the segment nothing is known to be visible.
                hidden.push_back({i == 0 && begin <= tolerance ? 0.0 : begin, by.end});
                was_hidden = true;
            }
        }
        if (!was_hidden || hidden.back().end >= 1.0) return;
        const double end = narrow(hidden.back().end, 1.0, 1.0, tolerance);
        hidden.back().end = 1.0 - end <= tolerance ? 1.0 : end;
    }

   private:
    /// The interval around s that one triangle hides; empty where s is visible.
    Interval hidden_at(double s) {
        const auto hides = [&](const Occluding& by) { return by.hides(tracer_, *segment_); };
        if (const Interval* interval = known_.around(s, hides)) return *interval;
        const auto hit = tracer_.occluder(vec3(segment_->at(s)), segment_->ignore);
        if (!hit) return {};
        const Occluding by(tracer_, *hit);
        const Interval interval = hides(by);
        known_.remember({by, interval});
        // The ray is the judge: at its own sample the triangle hides, whatever rounding says.
        return interval.holds(s) ? interval : Interval{s, s};
    }

    /// Moves an end of a hidden interval to where the segment, visible at `seen`, becomes hidden; `way` leads out of
    /// it: -1 at its begin, 1 at its end.
    double narrow(double hidden, double seen, double way, double tolerance) {
        double visible = seen;
        for (int steps = 0; (visible - hidden) * way > tolerance && steps < 24; ++steps) {
            const double s = steps < 6 ? hidden + way * tolerance : 0.5 * (hidden + visible);
            const Interval by = hidden_at(s);
            if (by.begin > by.end)
                visible = s;
            else
                hidden = way < 0.0 ? std::min(s, by.begin) : std::max(s, by.end);
        }
        return way < 0.0 ? std::max(hidden, seen) : std::min(hidden, seen);
    }

    const Tracer& tracer_;
    const Segment* segment_ = nullptr;
    /// From segment to segment: neighbours are mostly hidden by the same triangles.
    Remembered<Occluding, 8> known_;
};

/// Runs of a range of pieces.
class Runner {
   public:
    Runner(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, Runs& out)
        : clipped_(clipped), paths_(paths), tracer_(tracer), out_(out), marcher_(tracer) {}

    void add(Index piece) {
        piece_ = piece;
        open_ = false;
        const bool in_image = paths_.placement[clipped_.path[piece]] == none;
        const Index last = clipped_.pieces.end(piece) - 1;
        for (Index i = clipped_.pieces.begin(piece); i < last; ++i) {
            const Index samples = clipped_.sample_count[i];
            if (samples == 0) continue;
            const double arc = clipped_.arc_px[i], end = clipped_.arc_px[i + 1], length = end - arc;
            hidden_.clear();
            if (!in_image) marcher_.march(segment_at(clipped_, paths_, tracer_, piece, i), samples, length, hidden_);
            double from = arc;
            for (const Interval& gap : hidden_) {
                visible(from, arc + gap.begin * length);
                from = gap.end < 1.0 ? arc + gap.end * length : end;
            }
            visible(from, end);
        }
        close();
    }

   private:
    void visible(double start, double end) {
        if (end - start <= 1e-9) return;
        if (open_ && start - end_ <= 1e-6) {
            end_ = end;
            return;
        }
        close();
        open_ = true;
        start_ = start;
        end_ = end;
    }

    void close() {
        if (open_) out_.push(piece_, start_, end_);
        open_ = false;
    }

    const ClippedPaths& clipped_;
    const Paths& paths_;
    const Tracer& tracer_;
    Runs& out_;
    Marcher marcher_;
    std::vector<Interval> hidden_;
    Index piece_ = 0;
    bool open_ = false;
    double start_ = 0.0, end_ = 0.0;
};

}  // namespace

Runs exact_visibility(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Cancel& cancel) {
    check_same_paths(clipped, paths, "exact_visibility");
    tracer.check_current();
    return runs_by_blocks(clipped.path.size(), pieces_per_block, [&](Runs& runs, std::size_t begin, std::size_t end) {
        cancel.poll();
        Runner runner(clipped, paths, tracer, runs);
        for (std::size_t q = begin; q < end; ++q) runner.add(static_cast<Index>(q));
    });
}

}  // namespace fovea
