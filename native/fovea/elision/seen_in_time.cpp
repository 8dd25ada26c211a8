// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/seen_in_time.h>

#include <algorithm>
#include <cmath>
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

constexpr double same_place = 1e-9;     // of a path's length: parts as near as that follow each other
constexpr double most_drawn_out = 4.0;  // by how much a line is longer where it is found again

/// Appends what stretches say of an interval of their path, from .. to or against it, that lies here at other lengths.
void add_mapped(In<Stretch> stretches, double from, double to, double here_from, double here_to,
                std::vector<Stretch>& out) {
    const std::size_t first = out.size();
    const double length = to - from, low = std::min(from, to), high = low + std::abs(length);
    if (length == 0.0) return;
    const auto place = [&](double arc) {
        return glm::mix(here_from, here_to, (std::clamp(arc, low, high) - from) / length);
    };
    auto stretch = std::ranges::upper_bound(stretches, low, {}, &Stretch::to);
    for (; stretch != stretches.end() && stretch->from < high; ++stretch) {
        const double a = place(stretch->from), b = place(stretch->to);
        out.push_back({std::min(a, b), std::max(a, b), stretch->seen});
    }
    if ((length > 0.0) != (here_to > here_from)) std::reverse(out.begin() + std::ptrdiff_t(first), out.end());
}

/// What another frame says of the lines of the mesh.
class OfMesh {
   public:
    /// Borrows.
    OfMesh(const SeenLines& now, const SeenLines& there)
        : now_(now), there_(there), part_(matched_parts(now.parts, there.parts)) {}

    /// Appends what is known of a part of a path.
    void add(Index part, std::vector<Stretch>& out) const {
        if (part_[part] == none) return;
        const LinePart &here = now_.parts[part], &other = there_.parts[part_[part]];
        add_mapped(there_.stretches[other.path], other.from, other.to, here.from, here.to, out);
    }

   private:
    const SeenLines &now_, &there_;
    Array<Index> part_;
};

/// What another frame says of the lines of the view.
class OfView {
   public:
    /// Borrows. `found`: of the places of `now`.
    OfView(const SeenLines& now, const SeenLines& there, In<FoundPlace> found)
        : now_(now), there_(there), found_(found) {}

    /// Appends what is known of a piece of a path.
    void add(Index piece, std::vector<Stretch>& out) const {
        const ViewLines &lines = *now_.of_view, &there = *there_.of_view;
        for (Index j = lines.rows.begin(piece); j + 1 < lines.rows.end(piece); ++j) {
            const double from = lines.places[j].arc_space, to = lines.places[j + 1].arc_space;
            const FoundPlace &a = found_[j], &b = found_[j + 1];
            if (a.place != none && b.place != none && there.places[a.place].piece == there.places[b.place].piece) {
                const double first = arc_there(a), last = arc_there(b);
                if (first != last && std::abs(last - first) <= most_drawn_out * (to - from)) {
                    add_mapped(there_.stretches[path_there(a)], first, last, from, to, out);
                    continue;
                }
            }
            const double middle = 0.5 * (from + to);
            add(from, middle, j, out);
            add(middle, to, j + 1, out);
        }
    }

    /// Whether a place is seen; none where that is not known.
    std::optional<bool> is_seen(Index place) const {
        const FoundPlace& at = found_[place];
        if (at.place == none) return at.inside ? std::optional(false) : std::nullopt;
        return elision::is_seen(there_.stretches[path_there(at)], arc_there(at));
    }

   private:
    Index path_there(const FoundPlace& at) const {
        return there_.of_view->path[there_.of_view->places[at.place].piece];
    }

    double arc_there(const FoundPlace& at) const {
        const ViewLines& lines = *there_.of_view;
        const ViewLines::Place& place = lines.places[at.place];
        const auto arc_space = [&](Index j) { return lines.places[j].arc_space; };
        const double arc = place.arc_space + slope_at(lines, at.place, arc_space) * at.beyond;
        return std::clamp(arc, arc_space(lines.rows.begin(place.piece)), arc_space(lines.rows.end(place.piece) - 1));
    }

    void add(double from, double to, Index place, std::vector<Stretch>& out) const {
        if (const std::optional<bool> seen = is_seen(place); seen && from < to) out.push_back({from, to, *seen});
    }

    const SeenLines &now_, &there_;
    In<FoundPlace> found_;
};

/// Where the places of the lines of the view are in the frame beside theirs. A line that is seen goes on in one that is
/// seen there, whatever its definition: a suggestive contour in a contour. What is hidden right beside something that
/// is seen stays so: only what hides it would be drawn twice.
Array<FoundPlace> found_beside(const SeenLines& now, const SeenLines& there) {
    const ViewLines& lines = *now.of_view;
    const MovedPlaces moved(lines, *there.of_view);
    Array<FoundPlace> found = moved.found();
    const Array<FoundPlace> seen = moved.beside(there.seen);
    std::vector<std::ptrdiff_t> more(lines.pose.placed.size());  // per object: places that are found than others
    for (std::size_t j = 0; j < found.size(); ++j) {
        if (now.seen[j] && seen[j].place != none)
            found[j] = seen[j];
        else if (!now.seen[j] && now.beside[j])
            found[j] = {};
        if (found[j].inside) more[lines.places[j].placed] += found[j].place == none ? -1 : 1;
    }
    for (std::size_t j = 0; j < found.size(); ++j)
        if (found[j].place == none && more[lines.places[j].placed] < 0) found[j].inside = false;
    return found;
}

/// Where places are that were found in one frame, in the next one. `next`: of the places of `lines`, which are those of
/// the former. What was lost stays so.
Array<FoundPlace> found_along(In<FoundPlace> found, const ViewLines& lines, In<FoundPlace> next) {
    return parallel_map<FoundPlace>(found.size(), [&](std::size_t j) {
        FoundPlace at = found[j];
        if (at.place == none) return FoundPlace{};
        const Index piece = lines.places[at.place].piece, first = lines.rows.begin(piece);
        const double arc = lines.places[at.place].arc + at.beyond;
        const Index nearest = first + Index(std::lround(lines.number_at(piece, arc)));
        FoundPlace then = next[nearest];
        const double inside = std::clamp(arc, lines.places[first].arc, lines.places[lines.rows.end(piece) - 1].arc);
        const double beyond = inside - lines.places[nearest].arc;
        then.beyond += then.same ? beyond : -beyond;
        then.same = at.same == then.same;
        return then;
    });
}

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

SeenInTime::SeenInTime(const Paths& paths, const SeenLines& now, In<SeenNear> near, int frames)
    : paths_(paths), now_(now), frames_(frames), there_(2 * frames + 1), found_(2 * frames + 1) {
    for (const auto& [away, lines] : near) {
        check(away != 0 && std::abs(away) <= frames, "visibility in time: a frame is not near by");
        there_[frames + away] = lines;
    }
    for (const int way : {-1, 1}) {
        const SeenLines* before = &now;
        for (int away = way; std::abs(away) <= frames && there_[frames + away]; away += way) {
            const SeenLines& lines = *there_[frames + away];
            Array<FoundPlace>& found = found_[frames + away];
            found = found_beside(*before, lines);
            if (before != &now) found = found_along(found_[frames + away - way], *before->of_view, found);
            before = &lines;
        }
    }
    // Beyond a frame that is not given, nothing is found.
    for (Array<FoundPlace>& found : found_) found.resize(now.of_view->places.size(), FoundPlace{});
}

std::vector<std::vector<Ramp>> SeenInTime::ramps() const {
    std::vector<std::optional<OfMesh>> of_mesh(there_.size());
    parallel_for(there_.size(), 1, [&](std::size_t k) {
        if (there_[k]) of_mesh[k].emplace(now_, *there_[k]);
    });
    const ViewLines& lines = *now_.of_view;
    auto parts = lists_of<Index>(paths_.count(), [&](const auto& give) {
        for (Index i = 0; i < now_.parts.size(); ++i) give(now_.parts[i].path, i);
    });
    auto pieces = lists_of<Index>(paths_.count(), [&](const auto& give) {
        for (Index q = 0; q < lines.rows.count(); ++q)
            if (lines.rows.size(q) > 0) give(lines.path[q], q);
    });
    std::vector<std::vector<Ramp>> ramps(paths_.count());
    parallel_for(paths_.count(), 64, [&](std::size_t p) {
        const auto own_parts = parts[Index(p)], own_pieces = pieces[Index(p)];
        if (own_parts.empty() && own_pieces.empty()) return;
        std::ranges::sort(own_parts, {}, [&](Index i) { return std::min(now_.parts[i].from, now_.parts[i].to); });
        std::ranges::sort(own_pieces, {}, [&](Index q) { return lines.places[lines.rows.begin(q)].arc_space; });
        const double length = paths_.arc_obj[paths_.rows.end(Index(p)) - 1];
        std::vector<SeenAlong> moments(there_.size());
        moments[frames_] = along(now_.stretches[Index(p)]);
        std::vector<Stretch> stretches;
        const auto look = [&](int moment, int towards) {
            moments[moment] = moments[towards];
            if (!there_[moment]) return;
            stretches.clear();
            for (const Index part : own_parts) of_mesh[moment]->add(part, stretches);
            const OfView of_view(now_, *there_[moment], found_[moment]);
            for (const Index piece : own_pieces) of_view.add(piece, stretches);
            moments[moment] = along(stretches, moments[towards], length);
        };
        for (int k = 1; k <= frames_; ++k) {
            look(frames_ - k, frames_ - k + 1);
            look(frames_ + k, frames_ + k - 1);
        }
        ramps[p] = seen_over_time(moments, length);
    });
    return ramps;
}

Array<float> SeenInTime::shown_near() const {
    const std::size_t count = now_.of_view->places.size();
    Array<double> sum(count), seen(count);
    std::ranges::fill(sum, 0.0);
    std::ranges::fill(seen, 0.0);
    for (std::size_t k = 0; k < there_.size(); ++k) {
        if (!there_[k] || there_[k]->shown.empty()) continue;
        const OfView of_view(now_, *there_[k], found_[k]);
        parallel_for(count, 1024, [&](std::size_t j) {
            const FoundPlace& at = found_[k][j];
            if (at.place == none || !of_view.is_seen(Index(j)).value_or(false)) return;
            sum[j] += there_[k]->shown[at.place];
            seen[j] += 1.0;
        });
    }
    return parallel_map<float>(count, [&](std::size_t j) { return seen[j] > 0.0 ? float(sum[j] / seen[j]) : 1.0f; });
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
