// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/exact.h>

#include <algorithm>
#include <cmath>

#include <fovea/visibility/occluding.h>

namespace fovea {
namespace {

constexpr std::size_t pieces_per_block = 256;
/// Shadows remembered from segment to segment: neighbours are mostly hidden by the same triangles.
constexpr int remembered = 8;

/// Visibility along segments, one after the other, remembering what hid the last ones.
class Marcher {
   public:
    explicit Marcher(const Tracer& tracer) : tracer_(tracer) {}

    /// Appends the hidden intervals of a segment with `samples` samples, in screen fractions, ascending and disjoint.
    void march(const Segment& segment, Index samples, double length_px, std::vector<Interval>& hidden) {
        segment_ = &segment;
        for (Known& known : known_) known.interval_known = false;
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
                if (was_hidden) narrow_end(hidden.back(), s, tolerance);
                was_hidden = false;
                seen = s;
            } else if (was_hidden) {
                // Less than a sample between two shadows: no line is seen through it.
                hidden.back().end = std::max(hidden.back().end, by.end);
            } else {
                Interval found = by;
                narrow_begin(found, seen, i == 0, tolerance);
                hidden.push_back(found);
                was_hidden = true;
            }
        }
        if (was_hidden && hidden.back().end < 1.0) finish(hidden.back(), tolerance);
    }

   private:
    struct Known {
        Occluding by;
        Interval interval;  // on the current segment
        bool interval_known = false;
    };

    /// The interval around s that one triangle hides; empty where s is visible.
    Interval hidden_at(double s) {
        for (int i = 0; i < remembered; ++i) {
            Known& known = known_[order_[i]];
            if (!known.interval_known) {
                known.interval = known.by.hides(tracer_, *segment_);
                known.interval_known = true;
            }
            if (!known.interval.holds(s)) continue;
            if (i > 0) std::swap(order_[i], order_[i - 1]);
            return known.interval;
        }
        const auto hit = tracer_.occluder(vec3(segment_->at(s)), segment_->ignore);
        if (!hit) return {};
        return remember(*hit, s);
    }

    Interval remember(const Hit& hit, double s) {
        std::rotate(order_, order_ + remembered - 1, order_ + remembered);
        Known& known = known_[order_[0]];
        known = {Occluding(tracer_, hit), {}, true};
        known.interval = known.by.hides(tracer_, *segment_);
        // The ray is the judge: at its own sample the triangle hides, whatever rounding says.
        return known.interval.holds(s) ? known.interval : Interval{s, s};
    }

    /// Moves found.begin down to where the segment, visible at `seen`, becomes hidden. At the very beginning of the
    /// segment nothing is known to be visible.
    void narrow_begin(Interval& found, double seen, bool at_start, double tolerance) {
        double visible = seen;
        for (int steps = 0; found.begin - visible > tolerance && steps < 24; ++steps) {
            const double s = steps < 6 ? found.begin - tolerance : 0.5 * (found.begin + visible);
            const Interval by = hidden_at(s);
            if (by.begin > by.end) {
                visible = s;
            } else {
                found.begin = std::min(s, by.begin);
            }
        }
        found.begin = std::max(found.begin, seen);
        if (at_start && found.begin <= tolerance) found.begin = 0.0;
    }

    /// The same at the other side: visible at `seen`.
    void narrow_end(Interval& found, double seen, double tolerance) {
        double visible = seen;
        for (int steps = 0; visible - found.end > tolerance && steps < 24; ++steps) {
            const double s = steps < 6 ? found.end + tolerance : 0.5 * (found.end + visible);
            const Interval by = hidden_at(s);
            if (by.begin > by.end) {
                visible = s;
            } else {
                found.end = std::max(s, by.end);
            }
        }
        found.end = std::min(found.end, seen);
    }

    void finish(Interval& found, double tolerance) {
        narrow_end(found, 1.0, tolerance);
        if (1.0 - found.end <= tolerance) found.end = 1.0;
    }

    const Tracer& tracer_;
    const Segment* segment_ = nullptr;
    Known known_[remembered];
    std::uint8_t order_[remembered] = {0, 1, 2, 3, 4, 5, 6, 7};  // of known_, those that hid last before the others
};

/// Runs of a range of pieces.
class Runner {
   public:
    Runner(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer)
        : clipped_(clipped), paths_(paths), tracer_(tracer), marcher_(tracer) {}

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

    Runs out;

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
        if (!open_) return;
        out.push(piece_, start_, end_);
        open_ = false;
    }

    const ClippedPaths& clipped_;
    const Paths& paths_;
    const Tracer& tracer_;
    Marcher marcher_;
    std::vector<Interval> hidden_;
    Index piece_ = 0;
    bool open_ = false;
    double start_ = 0.0, end_ = 0.0;
};

}  // namespace

Runs exact_visibility(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Cancel& cancel) {
    const std::size_t pieces = clipped.path.size();
    check_same_paths(clipped, paths, "exact_visibility");
    tracer.check_current();
    std::vector<Runs> parts((pieces + pieces_per_block - 1) / pieces_per_block);
    parallel_blocks(pieces, pieces_per_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
        cancel.poll();
        Runner runner(clipped, paths, tracer);
        for (std::size_t q = begin; q < end; ++q) runner.add(static_cast<Index>(q));
        parts[b] = std::move(runner.out);
    });
    Runs runs;
    for (const Runs& part : parts) runs.append(part);
    return runs;
}

}  // namespace fovea
