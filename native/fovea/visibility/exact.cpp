// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/exact.h>

#include <algorithm>

#include <fovea/visibility/crowds.h>
#include <fovea/visibility/segment.h>

namespace fovea::visibility {
namespace {

/// Of pieces, of which a scene may have very many short ones or few long ones.
constexpr std::size_t points_per_block = 512;

/// Computes visibility along consecutive segments, with a cache of recent occluders.
class Marcher {
   public:
    explicit Marcher(const Tracer& tracer) : tracer_(tracer) {}

    /// Appends the hidden intervals of a segment with `samples` samples, in screen fractions, ascending and disjoint.
    void march(const Segment& segment, Index samples, double length_px, std::vector<Interval>& hidden) {
        segment_ = &segment;
        known_.next_segment();
        const double step = 1.0 / samples, tolerance = exact_tolerance_px / std::max(length_px, 1e-9);
        double seen = 0.0;  // last visible position, or 0
        bool was_hidden = false;
        End last{};  // of the last interval
        for (Index i = 0; i < samples; ++i) {
            const double s = (i + 0.5) * step;
            if (was_hidden && last.at >= s) {
                i = std::max(i, static_cast<Index>(std::min(last.at * samples - 0.5, samples - 1.0)));
                continue;
            }
            const Interval by = hidden_at(s);
            if (by.is_empty()) {
                if (was_hidden) hidden.back().end = narrow(last, s, 1.0, tolerance);
                was_hidden = false;
                seen = s;
            } else if (was_hidden) {
                // A gap of less than a sample between two shadows counts as hidden.
                if (by.end > last.at) last = {by.end, is_by_ray(by)};
            } else {
                const End first{by.begin, is_by_ray(by)};
                const double begin =
                    seen > 0.0 ? narrow(first, seen, -1.0, tolerance) : narrow_to_end(first, 0.0, -1.0, tolerance);
                // At the beginning of the segment no visible position is known.
                hidden.push_back({i == 0 && begin <= tolerance ? 0.0 : begin, 1.0});
                last = {by.end, is_by_ray(by)};
                was_hidden = true;
            }
        }
        if (!was_hidden) return;
        const double end = narrow_to_end(last, 1.0, 1.0, tolerance);
        hidden.back().end = 1.0 - end <= tolerance ? 1.0 : end;
    }

   private:
    /// An end of a hidden interval.
    struct End {
        double at;
        bool by_ray;  ///< a ray alone tells that it is hidden, and nothing of the points beside it
    };

    /// The interval around s that one triangle hides, or s alone if a ray tells no more; empty where s is visible.
    Interval hidden_at(double s) {
        const auto hides = [&](const Occluding& by) { return hidden_by(by, tracer_, *segment_); };
        if (const Interval* interval = known_.around(s, hides)) return *interval;
        const auto hit = tracer_.occluder(vec3(segment_->at(s)), segment_->ignore);
        if (!hit) return {};
        if (!segment_->ignore.leaves_to_rays(hit->placement)) {
            const Occluding by(tracer_, *hit);
            const Interval interval = hides(by);
            known_.remember({by, interval});
            if (interval.holds(s)) return interval;
        }
        // The ray is authoritative: the triangle hides at least the ray's own sample, despite rounding.
        return {s, s};
    }

    static bool is_by_ray(const Interval& hidden) { return hidden.begin == hidden.end; }

    /// Refines an end of a hidden interval, between `hidden` and the visible position `seen`; `way` points out of the
    /// interval: -1 at its begin, 1 at its end.
    double narrow(End hidden, double seen, double way, double tolerance) {
        double visible = seen;
        for (int steps = 0; (visible - hidden.at) * way > tolerance && steps < 24; ++steps) {
            // What hides a point just beyond an interval mostly hides many more.
            const bool beside = steps < 6 && !hidden.by_ray;
            const double s = beside ? hidden.at + way * tolerance : 0.5 * (hidden.at + visible);
            const Interval by = hidden_at(s);
            if (by.is_empty())
                visible = s;
            else
                hidden = {way < 0.0 ? std::min(s, by.begin) : std::max(s, by.end), is_by_ray(by)};
        }
        return way < 0.0 ? std::max(hidden.at, seen) : std::min(hidden.at, seen);
    }

    /// The same up to an end of the segment, of which it is not known whether it is visible. Where rays alone tell, it
    /// is asked for first: most lines that their own surface hides somewhere are hidden all along a segment.
    double narrow_to_end(const End& hidden, double end, double way, double tolerance) {
        const bool asks = hidden.by_ray && (end - hidden.at) * way > tolerance;
        return asks && !hidden_at(end).is_empty() ? end : narrow(hidden, end, way, tolerance);
    }

    const Tracer& tracer_;
    const Segment* segment_ = nullptr;
    /// Kept across segments: neighbors are mostly hidden by the same triangles.
    Remembered<Occluding, 8> known_;
};

/// A visible part of a segment, in pixels of its piece.
struct Part {
    Index piece;
    double start, end;
};

/// Calls visit(piece, segment) for the segments of rows of points whose first points are `begin` to before `end`.
template <typename Visit>
void each_segment(const Rows& pieces, std::size_t begin, std::size_t end, const Visit& visit) {
    const auto after = std::ranges::upper_bound(pieces.offsets, Index(begin));
    for (Index q = Index(after - pieces.offsets.begin()) - 1; q < pieces.count() && pieces.begin(q) < end; ++q)
        for (Index i = std::max(pieces.begin(q), Index(begin)); i + 1 < pieces.end(q) && i < end; ++i) visit(q, i);
}

/// Runs of parts in order, of which those that touch are one.
Runs joined(In<Part> parts) {
    Runs runs;
    for (std::size_t i = 0; i < parts.size();) {
        Part run = parts[i++];
        while (i < parts.size() && parts[i].piece == run.piece && parts[i].start - run.end <= same_place_px)
            run.end = parts[i++].end;
        runs.push(run.piece, run.start, run.end);
    }
    return runs;
}

/// Adds to runs of the first pieces of crowds (first_of_crowds) those of all others.
Runs with_crowds(const ClippedPaths& clipped, const Runs& asked, In<Index> first) {
    const Rows rows = runs_of_pieces(clipped, asked);
    return runs_by_blocks(first.size(), pieces_per_block, [&](Runs& runs, std::size_t begin, std::size_t end) {
        for (Index q = Index(begin); q < end; ++q) {
            const double own_first = clipped.first_arc(q), own_last = clipped.last_arc(q);
            const double its_first = clipped.first_arc(first[q]), its_last = clipped.last_arc(first[q]);
            const auto own = [&](double arc) {
                return arc < its_last ? std::clamp(arc + (own_first - its_first), own_first, own_last) : own_last;
            };
            for (Index r = rows.begin(first[q]); r < rows.end(first[q]); ++r)
                runs.push(q, own(asked.start_px[r]), own(asked.end_px[r]));
        }
    });
}

/// View-space point `offset_px` pixels to the left of screen fraction s of segment i.
vec3 point_beside(const ClippedPaths& clipped, const View& view, const dmat4& clip_to_view, Index i, double s,
                  double offset_px) {
    const dvec2 p(clipped.px[i]), way = dvec2(clipped.px[i + 1]) - p;
    const double length = glm::length(way);
    const dvec2 left = length > 0.0 ? dvec2(-way.y, way.x) / length : dvec2(0.0, 1.0);
    const double a = -clipped.position_view[i].z, b = -clipped.position_view[i + 1].z;
    const double distance = view.orthographic ? glm::mix(a, b, s) : a * b / glm::mix(b, a, s);
    return vec3(from_pixels(view, clip_to_view, p + s * way + offset_px * left, distance));
}

}  // namespace

Runs exact_visibility(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Cancel& cancel) {
    check_same_paths(clipped, paths, "exact_visibility");
    tracer.check_current();
    const Array<Index> first = first_of_crowds(clipped, paths, tracer);
    const auto find = [&](std::size_t begin, std::size_t end, Array<Part>& parts) {
        cancel.poll();
        Marcher marcher(tracer);
        std::vector<Interval> hidden;
        each_segment(clipped.pieces, begin, end, [&](Index q, Index i) {
            const Index samples = clipped.sample_count[i];
            if (samples == 0 || (!first.empty() && first[q] != q)) return;
            const double arc = clipped.arc_px[i], last = clipped.arc_px[i + 1], length = last - arc;
            hidden.clear();
            if (paths.placement[clipped.path[q]] != none)
                marcher.march(segment_at(clipped, paths, tracer, q, i), samples, length, hidden);
            double from = arc;
            const auto add_up_to = [&](double to) {
                if (to > from) parts.push_back({q, from, to});
            };
            for (const Interval& gap : hidden) {
                add_up_to(arc + gap.begin * length);
                from = gap.end < 1.0 ? arc + gap.end * length : last;
            }
            add_up_to(last);
        });
    };
    const Runs asked = joined(parallel_collect<Part>(clipped.px.size(), points_per_block, find));
    return first.empty() ? asked : with_crowds(clipped, asked, first);
}

Array<std::uint8_t> seen_beside(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, double offset_px,
                                const Cancel& cancel) {
    check_same_paths(clipped, paths, "seen_beside");
    tracer.check_current();
    const View& view = tracer.view();
    const dmat4 clip_to_view = glm::inverse(view.view_to_clip);
    Array<std::uint8_t> seen(clipped.samples, 0);
    parallel_blocks(clipped.px.size(), points_per_block, [&](auto, std::size_t begin, std::size_t end) {
        cancel.poll();
        each_segment(clipped.pieces, begin, end, [&](Index q, Index i) {
            const Index count = clipped.sample_count[i], start = clipped.sample_start[i];
            const bool in_image = paths.placement[clipped.path[q]] == none;
            const bool asks = !in_image && count > 0;
            const Ignore ignore = asks ? segment_at(clipped, paths, tracer, q, i).ignore : Ignore();
            for (Index j = 0; j < count; ++j) {
                const vec3 beside = point_beside(clipped, view, clip_to_view, i, (j + 0.5) / count, offset_px);
                seen[start + j] = in_image || !tracer.occluder(beside + ignore.above, ignore);
            }
        });
    });
    return seen;
}

}  // namespace fovea::visibility
