// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/shade.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/visibility/exact.h>
#include <fovea/visibility/segment.h>
#include <fovea/visibility/shade_along.h>

namespace fovea::visibility {
namespace {

constexpr std::size_t shaded_per_block = 32;
/// Cuts one run where along.at(arc) changes.
class Cutter {
   public:
    Cutter(const ClippedPaths& clipped, ShadeAlong& along, double gap_px, ShadedRuns& out)
        : clipped_(clipped), along_(along), gap_(gap_px), out_(out) {}

    void cut(const Runs& runs, std::size_t run) {
        piece_ = runs.piece[run];
        parts_.clear();
        const double end = runs.end_px[run];
        begin_ = runs.start_px[run];
        // At an end the faces around a corner meet: it is as what is right beside it.
        const double inset = std::min(0.5 * exact_tolerance_px, 0.25 * (end - begin_)), last = end - inset;
        before_ = begin_ + inset;
        shade_ = along_.at(piece_, before_);
        for (Index i = clipped_.segment_at(piece_, begin_); i + 1 < clipped_.pieces.end(piece_); ++i) {
            if (clipped_.arc_px[i] >= end) break;
            const double length = clipped_.arc_px[i + 1] - clipped_.arc_px[i];
            for (Index j = 0; j < clipped_.sample_count[i]; ++j) {
                const double here = clipped_.arc_px[i] + (j + 0.5) / clipped_.sample_count[i] * length;
                if (here > before_ && here < last) go_to(here);
            }
        }
        go_to(last);
        push(end);
        close_gaps();
        for (const Part& part : parts_) {
            if (part.end <= part.begin) continue;
            out_.runs.push(piece_, part.begin, part.end, runs.invisibility[run]);
            out_.shade.push_back(part.shade);
        }
    }

   private:
    /// Looks at the next place of the run.
    void go_to(double arc) {
        while (before_ < arc) {
            double same = before_, other = arc;
            Shade next = along_.at(piece_, arc);
            if (next == shade_) break;
            while (other - same > exact_tolerance_px) {
                const double middle = 0.5 * (same + other);
                const Shade here = along_.at(piece_, middle);
                if (here == shade_) {
                    same = middle;
                } else {
                    other = middle;
                    next = here;
                }
            }
            push(0.5 * (same + other));
            before_ = other;
            shade_ = next;
        }
        before_ = arc;
    }

    void push(double end) {
        parts_.push_back({begin_, end, shade_});
        begin_ = end;
    }

    /// Short parts between two of one shade become theirs.
    void close_gaps() {
        std::size_t count = 0;
        for (const Part& part : parts_) {
            if (count >= 2 && parts_[count - 2].shade == part.shade &&
                parts_[count - 1].end - parts_[count - 1].begin < gap_)
                parts_[--count - 1].end = part.end;
            else
                parts_[count++] = part;
        }
        parts_.resize(count);
    }

    struct Part {
        double begin, end;
        Shade shade;
    };
    const ClippedPaths& clipped_;
    ShadeAlong& along_;
    double gap_;
    ShadedRuns& out_;
    std::vector<Part> parts_;
    Index piece_ = none;
    double begin_ = 0.0, before_ = 0.0;
    Shade shade_ = Shade::lit;
};

}  // namespace

ShadedRuns by_shade(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const View& view,
                    const Runs& runs, In<std::uint8_t> cut, double gap_px, const Cancel& cancel) {
    check_same_paths(clipped, paths, "shade");
    check_runs(clipped, runs);
    check(clipped.path.empty() || clipped.path.back() < cut.size(), "cut: one value per path expected");
    const Shades shades(scene);
    const dvec4 viewer = glm::inverse(view.world_to_view) * (view.orthographic ? dvec4(0, 0, 1, 0) : dvec4(0, 0, 0, 1));
    ShadedRuns all;
    for (const ShadedRuns& part : parallel_parts<ShadedRuns>(
             runs.size(), shaded_per_block, [&](ShadedRuns& out, std::size_t begin, std::size_t end) {
                 ShadeAlong along(clipped, paths, scene, shades, viewer);
                 Cutter cutter(clipped, along, gap_px, out);
                 for (std::size_t r = begin; r < end; ++r) {
                     cancel.poll();
                     if (cut[clipped.path[runs.piece[r]]]) cutter.cut(runs, r);
                 }
             })) {
        all.runs.append(part.runs);
        all.shade.insert(all.shade.end(), part.shade.begin(), part.shade.end());
    }
    return all;
}

}  // namespace fovea::visibility
