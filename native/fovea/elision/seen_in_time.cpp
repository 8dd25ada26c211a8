// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/seen_in_time.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include <fovea/base/check.h>
#include <fovea/project/piece_arcs.h>
#include <fovea/runs/chain.h>
#include <fovea/visibility/piece_samples.h>

namespace fovea::elision {
namespace {

using Stretch = SeenLines::Stretch;
using project::PieceArcs;

constexpr double same_place = 1e-9;  // of a path's length: parts as near as that follow each other

/// The lines of another frame along the paths of this one.
class Mapped {
   public:
    /// Borrows.
    Mapped(const SeenLines& now, const SeenLines& there)
        : now_(now), there_(there), part_(matched_parts(now.parts, there.parts)) {}

    /// Appends what is known there of a part of a path here.
    void add(Index part, std::vector<Stretch>& out) const {
        if (part_[part] == none) return;
        const LinePart &here = now_.parts[part], &other = there_.parts[part_[part]];
        const double length = other.to - other.from, low = std::min(other.from, other.to),
                     high = low + std::abs(length);
        if (length == 0.0) return;
        const auto place = [&](double arc) {
            return glm::mix(here.from, here.to, (std::clamp(arc, low, high) - other.from) / length);
        };
        const In<Stretch> stretches = there_.stretches[other.path];
        auto stretch = std::ranges::upper_bound(stretches, low, {}, &Stretch::to);
        for (; stretch != stretches.end() && stretch->from < high; ++stretch) {
            const double a = place(stretch->from), b = place(stretch->to);
            out.push_back({std::min(a, b), std::max(a, b), stretch->seen});
        }
    }

   private:
    const SeenLines &now_, &there_;
    Array<Index> part_;
};

/// What stretches say, ascending, and elsewhere what another moment does.
SeenAlong along(In<Stretch> stretches, const SeenAlong& elsewhere, double length) {
    SeenAlong found;
    double at = 0.0;
    for (const Stretch& stretch : stretches) {
        if (stretch.from > at + same_place * length) {
            found.go_on(elsewhere, at, stretch.from);
            at = stretch.from;
        }
        found.go_on(at, stretch.seen);
        at = std::max(at, stretch.to);
    }
    if (at < length * (1.0 - same_place)) found.go_on(elsewhere, at, length);
    return found;
}

/// What stretches say, each up to the next one.
SeenAlong along(In<Stretch> stretches) {
    SeenAlong found;
    for (const Stretch& stretch : stretches) found.go_on(stretch.from, stretch.seen);
    return found;
}

/// Calls visit(piece) for the pieces of paths with ramps.
template <typename Visit>
void each_piece_with_ramps(const ClippedPaths& clipped, const std::vector<std::vector<Ramp>>& ramps,
                           const Visit& visit) {
    parallel_for(clipped.path.size(), 64, [&](std::size_t q) {
        if (!ramps[clipped.path[q]].empty()) visit(Index(q));
    });
}

float share_at(In<Ramp> ramps, double arc) {
    const auto after = std::ranges::upper_bound(ramps, arc, {}, &Ramp::to);
    const Ramp& ramp = after == ramps.end() ? ramps.back() : *after;
    return glm::mix(ramp.at_from, ramp.at_to, float(std::clamp((arc - ramp.from) / (ramp.to - ramp.from), 0.0, 1.0)));
}

/// Where the share is more than `least`, in pixels of a piece.
void spans_above(In<Ramp> ramps, float least, const ClippedPaths& clipped, const PieceArcs& arcs, Index piece,
                 std::vector<Span>& out) {
    out.clear();
    const double begin = clipped.first_arc(piece), end = clipped.last_arc(piece);
    const double first = arcs.in_space(begin), last = arcs.in_space(end);
    for (const Ramp& ramp : ramps) {
        if (ramp.to <= first || ramp.from >= last || std::max(ramp.at_from, ramp.at_to) <= least) continue;
        const double crossing =
            ramp.from + (ramp.to - ramp.from) * ((least - ramp.at_from) / (double(ramp.at_to) - ramp.at_from));
        const double from = ramp.at_from > least ? ramp.from : crossing, to = ramp.at_to > least ? ramp.to : crossing;
        const Span span{from <= first ? begin : arcs.in_image(from), to >= last ? end : arcs.in_image(to)};
        if (span.begin < span.end) out.push_back(span);
    }
    join_spans(out, [](const Span& before, const Span& span) { return span.begin <= before.end + same_place_px; });
}

}  // namespace

std::vector<std::vector<Ramp>> seen_in_time(const Paths& paths, const SeenLines& now, In<SeenNear> near, int frames) {
    std::vector<std::optional<Mapped>> mapped(2 * frames + 1);
    for (const auto& [away, lines] : near)
        check(away != 0 && std::abs(away) <= frames, "visibility in time: a frame is not near by");
    parallel_for(near.size(), 1, [&](std::size_t k) { mapped[frames + near[k].first].emplace(now, *near[k].second); });
    auto parts = lists_of<Index>(paths.count(), [&](const auto& give) {
        for (Index i = 0; i < now.parts.size(); ++i) give(now.parts[i].path, i);
    });
    std::vector<std::vector<Ramp>> ramps(paths.count());
    parallel_for(paths.count(), 64, [&](std::size_t p) {
        const auto of_path = parts[Index(p)];
        if (of_path.empty()) return;
        std::ranges::sort(of_path, {}, [&](Index i) { return std::min(now.parts[i].from, now.parts[i].to); });
        const double length = paths.arc_obj[paths.rows.end(Index(p)) - 1];
        std::vector<SeenAlong> moments(mapped.size());
        moments[frames] = along(std::as_const(now.stretches)[Index(p)]);
        std::vector<Stretch> known;
        const auto look = [&](int moment, int towards) {
            moments[moment] = moments[towards];
            if (!mapped[moment]) return;
            known.clear();
            for (const Index part : of_path) {
                const std::size_t before = known.size();
                mapped[moment]->add(part, known);
                if (now.parts[part].from > now.parts[part].to)
                    std::ranges::sort(known.begin() + before, known.end(), {}, &Stretch::from);
            }
            moments[moment] = along(known, moments[towards], length);
        };
        for (int k = 1; k <= frames; ++k) {
            look(frames - k, frames - k + 1);
            look(frames + k, frames + k - 1);
        }
        ramps[p] = seen_over_time(moments, length);
    });
    return ramps;
}

Array<float> seen_at_samples(const ClippedPaths& clipped, const Paths& paths,
                             const std::vector<std::vector<Ramp>>& ramps) {
    Array<float> seen(clipped.samples);
    std::ranges::fill(seen, 1.0f);
    each_piece_with_ramps(clipped, ramps, [&](Index q) {
        const PieceArcs arcs(clipped, paths, q);
        const PieceSamples samples(clipped, q);
        for (std::ptrdiff_t s = 0; s < samples.count(); ++s)
            seen[samples.in_atlas(s)] = share_at(ramps[clipped.path[q]], arcs.in_space(samples.arc(s)));
    });
    return seen;
}

Runs seen_runs(const ClippedPaths& clipped, const Paths& paths, const Runs& runs,
               const std::vector<std::vector<Ramp>>& ramps, float least) {
    const Rows rows = runs_of_pieces(clipped, runs);
    return runs_by_blocks(clipped.path.size(), 256, [&](Runs& out, std::size_t begin, std::size_t end) {
        std::vector<Span> spans;
        for (Index q = Index(begin); q < end; ++q) {
            const std::vector<Ramp>& of_path = ramps[clipped.path[q]];
            if (of_path.empty()) {
                for (Index r = rows.begin(q); r < rows.end(q); ++r) out.push(runs, r);
                continue;
            }
            spans_above(of_path, least, clipped, PieceArcs(clipped, paths, q), q, spans);
            replace_visible(runs, rows, q, spans, out);
        }
    });
}

}  // namespace fovea::elision
