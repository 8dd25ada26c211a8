// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/marks.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <fovea/base/check.h>
#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>

namespace fovea::stroke {
namespace {

constexpr double reach = 8.0;        // reference pixels from a moved point to its line
constexpr double trusted = 4.0;      // reference pixels at which a place counts for 1 / e
constexpr double same_way = 0.7;     // cosine between the directions of a line found again
constexpr double same_depth = 0.05;  // of the distance from the eye
constexpr double least_trust = 0.2;  // below it a place is nowhere
constexpr double stiff = 0.02;       // how little a place gives in to its neighbors, where it has no value itself

/// Where a place is on the lines of another frame.
struct Found {
    Index place = none;   ///< the nearest one there
    double beyond = 0.0;  ///< pixels from it along its line
    double trust = 0.0;
    bool same = true;  ///< whether both lines run the same way
};

/// Where points of one frame's lines are in another frame.
class Carrier {
   public:
    Carrier(const ViewLines& from, const ViewLines& to) : from_(from), to_(to) {
        for (const ViewLines::Placed& placed : from.placed) {
            const auto at = std::ranges::lower_bound(to.placed, placed.id, {}, &ViewLines::Placed::id);
            number_.push_back(at != to.placed.end() && at->id == placed.id ? Index(at - to.placed.begin()) : none);
        }
    }

    /// Number among those placed there; `none` if it is not.
    Index number(const ViewLines::Place& place) const { return number_[place.placed]; }

    /// View space.
    dvec3 position(const ViewLines::Place& place) const {
        const ViewLines::Placed &here = from_.placed[place.placed], &there = to_.placed[number(place)];
        dvec3 at = place.position;
        if (!here.positions.empty() && here.positions.size() == there.positions.size()) {
            at = dvec3(0.0);
            for (int k = 0; k < 3; ++k) at += place.shares[k] * dvec3(there.positions[place.vertices[k]]);
        }
        return dvec3(there.object_to_view * dvec4(at, 1.0));
    }

   private:
    const ViewLines &from_, &to_;
    std::vector<Index> number_;
};

/// Per place of `now`: where it is on the lines of another frame.
Array<Found> found_on(const ViewLines& now, const ViewLines& there) {
    const Carrier carrier(now, there);
    const double scale = there.view.reference_scale;
    struct Moved {
        dvec2 px;
        double depth;
    };
    const Array<Moved> moved = parallel_map<Moved>(now.places.size(), [&](std::size_t j) {
        if (carrier.number(now.places[j]) == none) return Moved{dvec2(0.0), NAN};
        const dvec3 position = carrier.position(now.places[j]);
        const dvec4 clip = there.view.view_to_clip * dvec4(position, 1.0);
        const dvec2 px = to_pixels(there.view, clip);
        const bool seen = clip.w > 0.0 && std::abs(px.x) < 1e6 && std::abs(px.y) < 1e6;
        return Moved{px, seen ? -position.z : NAN};
    });
    Array<Found> found(now.places.size());
    parallel_for(found.size(), 256, [&](std::size_t j) {
        const ViewLines::Place& place = now.places[j];
        Found& best = found[j] = {};
        if (std::isnan(moved[j].depth)) return;
        const Index first = now.rows.begin(place.piece), last = now.rows.end(place.piece) - 1;
        const Moved &before = moved[std::max<std::size_t>(j, first + 1) - 1],
                    &after = moved[std::min<std::size_t>(j + 1, last)];
        const dvec2 across = after.px - before.px;
        const double length = glm::length(across);
        const dvec2 way = std::isnan(before.depth + after.depth) || length == 0.0 ? place.way : across / length;
        double nearest = reach * scale;
        there.grid->near(moved[j].px, [&](std::size_t k) {
            const ViewLines::Place& other = there.places[k];
            const double away = glm::distance(moved[j].px, other.px), along = glm::dot(way, other.way);
            if (away >= nearest || std::abs(along) < same_way || other.placed != carrier.number(place) ||
                (other.kinds & place.kinds) == 0 ||
                std::abs(other.depth - moved[j].depth) > same_depth * std::abs(moved[j].depth))
                return;
            nearest = away;
            const double beyond = glm::dot(moved[j].px - other.px, other.way);
            const double aside = std::abs(cross(other.way, moved[j].px - other.px)) / (trusted * scale);
            best = {Index(k), beyond, std::exp(-aside * aside), along > 0.0};
        });
    });
    return found;
}

double wrapped(double difference, double period) { return difference - period * std::round(difference / period); }

/// How values change per pixel of arc length at a place, over its neighbors.
double slope_at(const ViewLines& lines, In<double> values, Index place) {
    const Index piece = lines.places[place].piece;
    const Index before = std::max(place, lines.rows.begin(piece) + 1) - 1;
    const Index after = std::min(place + 1, lines.rows.end(piece) - 1);
    return (values[after] - values[before]) / (lines.places[after].arc - lines.places[before].arc);
}

/// Differences along a line that are known up to whole periods, as one that goes on: the first that counts is as near
/// to 0 as it can be, each other to that before it. `trust` 0: unknown.
void go_on(std::span<double> differences, In<double> trust, double period) {
    double last = 0.0;
    for (std::size_t k = 0; k < differences.size(); ++k) {
        if (trust[k] == 0.0) continue;
        differences[k] = last + wrapped(differences[k] - last, period);
        last = differences[k];
    }
}

/// Solves for what is near to `wanted` by `trust`, and changes little from one to the next: least squares, with the
/// squares of changes times `stiff`. What does not fit together stays apart: marks would have to slide to meet.
void fill(std::span<double> wanted, In<double> trust) {
    const std::size_t n = wanted.size();
    std::vector<double> diagonal(n), right(n);
    for (std::size_t k = 0; k < n; ++k) {
        diagonal[k] = trust[k] + stiff * (double(k > 0) + double(k + 1 < n));
        right[k] = trust[k] * wanted[k];
        if (k == 0) continue;
        const double share = stiff / diagonal[k - 1];
        diagonal[k] -= share * stiff;
        right[k] += share * right[k - 1];
    }
    wanted[n - 1] = right[n - 1] / diagonal[n - 1];
    for (std::size_t k = n - 1; k-- > 0;) wanted[k] = (right[k] + stiff * wanted[k + 1]) / diagonal[k];
}

}  // namespace

Array<double> handed_on(const ViewLines& now, const ViewLines& there, In<double> values) {
    check(values.size() == there.places.size(), "marks: one per place of the other lines expected");
    const Array<Found> found = found_on(now, there);
    const Array<double> own = own_marks(now);
    Array<double> made(now.places.size());
    parallel_for(now.rows.count(), 64, [&](std::size_t q) {
        const Index begin = now.rows.begin(Index(q)), size = now.rows.size(Index(q));
        if (size == 0) return;
        const std::span<double> out(made.data() + begin, size);
        std::vector<double> trust(size);
        // Arc length that ascends where the values do; else, where its own do.
        std::vector<double> along(size);
        bool any = false;
        for (Index k = 0; k < size; ++k) {
            const double step = own[begin + k] - own[begin + std::max(k, Index(1)) - 1];
            const Found& at = found[begin + k];
            const bool counts = at.place != none && at.trust >= least_trust;
            const double slope = counts ? slope_at(there, values, at.place) : 0.0;
            const double ascent = at.same ? slope : -slope;
            along[k] = (k > 0 ? along[k - 1] : own[begin]) + (counts ? std::copysign(step, ascent) : step);
            out[k] = counts ? values[at.place] + slope * at.beyond - along[k] : 0.0;
            trust[k] = counts ? at.trust : 0.0;
            any |= counts;
        }
        if (any) {
            go_on(out, trust, now.period[q]);
            fill(out, trust);
        }
        for (Index k = 0; k < size; ++k) out[k] += along[k];
        const double open = now.closed[q] ? wrapped(out[size - 1] - out[0], now.period[q]) : 0.0;
        for (Index k = 0; k < size; ++k) out[k] -= open * k / (size - 1);
    });
    return made;
}

namespace {

/// Marks that are at `last`, on the way to the nearest ones of those that are at `next`. Where they lie half a period
/// apart, one of them comes or goes.
Array<double> on_the_way(const ViewLines& lines, In<double> last, In<double> next, double share) {
    return parallel_map<double>(last.size(), [&](std::size_t j) {
        if (slope_at(lines, last, Index(j)) * slope_at(lines, next, Index(j)) < 0.0)
            return share < 0.5 ? last[j] : next[j];
        return last[j] + share * wrapped(next[j] - last[j], lines.period[lines.places[j].piece]);
    });
}

/// Values of the places of the frame at 0, handed on from a key at another offset, frame by frame; then to a moment of
/// it, unless that is null. Each frame of the way keeps its own: the next frames ask for them again.
Array<double> handed_along(const std::map<int, const ViewLines*>& lines, int key, const ViewLines* moment) {
    const ViewLines* here = lines.at(key);
    auto values = std::make_shared<const Array<double>>(own_marks(*here));
    std::uint64_t chain = here->number;
    while (key != 0) {
        const ViewLines* const before = here;
        key += key < 0 ? 1 : -1;
        here = lines.at(key);
        chain = hash_numbers(chain, here->number);
        auto kept = here->handed_on->find(chain);
        if (!kept) {
            kept = std::make_shared<const Array<double>>(handed_on(*here, *before, *values));
            here->handed_on->keep(chain, kept);
        }
        values = kept;
    }
    return moment ? handed_on(*moment, *here, *values) : *values;
}

}  // namespace

Marks marks_in_time(std::shared_ptr<const ViewLines> now, In<ViewNear> near, int since_key, int frames,
                    In<double> baked) {
    std::map<int, const ViewLines*> lines;
    for (const auto& [away, of] : near)
        if (of) lines.emplace(away, of.get());
    const bool is_itself = lines.emplace(0, now.get()).second;
    const ViewLines* const moment = is_itself ? nullptr : now.get();
    Marks marks{now, {}, {}, {}, 0.0};
    if (!baked.empty()) {
        const ViewLines& itself = *lines[0];
        check(baked.size() == itself.places.size(), "marks: those baked are not of these lines");
        marks.last = moment ? handed_on(*moment, itself, baked) : Array<double>(baked.begin(), baked.end());
        marks.at = marks.last;
        return marks;
    }
    int first = 0, last = 0;
    while (first > -since_key && lines.contains(first - 1)) --first;
    while (last < frames - since_key && lines.contains(last + 1)) ++last;
    marks.last = handed_along(lines, first, moment);
    marks.at = marks.last;
    if (first == 0 || last < frames - since_key) return marks;
    marks.next = handed_along(lines, last, moment);
    marks.share = double(-first) / (last - first);
    marks.at = on_the_way(*now, marks.last, marks.next, marks.share);
    return marks;
}

}  // namespace fovea::stroke
