// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/seen_over_time.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fovea::elision {
namespace {

/// An end of what is seen, on its way from one moment to the next.
struct Moving {
    double from, to;
    bool rises;  ///< from hidden to seen along the line

    bool passes(double place) const { return std::min(from, to) < place && place < std::max(from, to); }
    double time_at(double place) const { return std::clamp((place - from) / (to - from), 0.0, 1.0); }
    /// Whether the places that it passes are seen from then on.
    bool shows() const { return rises != (from < to); }
};

/// Number of the change of a kind that is nearest to a place; as many as there are if there is none.
std::size_t nearest(const SeenAlong& along, bool rises, double place) {
    std::size_t best = along.changes.size();
    for (std::size_t i = along.first == rises; i < along.changes.size(); i += 2)
        if (best == along.changes.size() || std::abs(along.changes[i] - place) < std::abs(along.changes[best] - place))
            best = i;
    return best;
}

/// The ends that are on their way between two moments.
std::vector<Moving> moving(const SeenAlong& before, const SeenAlong& after) {
    std::vector<Moving> found;
    for (std::size_t i = 0; i < before.changes.size(); ++i) {
        const bool rises = before.first == bool(i % 2);
        const std::size_t other = nearest(after, rises, before.changes[i]);
        if (other == after.changes.size() || nearest(before, rises, after.changes[other]) != i) continue;
        found.push_back({before.changes[i], after.changes[other], rises});
    }
    return found;
}

/// Adds the time for which two places are seen between two moments. `inside`: a place between them, no end of either
/// moment is.
void add_time(const SeenAlong& before, const SeenAlong& after, const std::vector<Moving>& ends, double inside,
              const double (&places)[2], double (&times)[2]) {
    std::vector<Moving> passing;
    for (const Moving& end : ends)
        if (end.passes(inside)) passing.push_back(end);
    for (int k = 0; k < 2; ++k) {
        std::ranges::sort(passing, {},
                          [&](const Moving& end) { return std::pair(end.time_at(places[k]), end.time_at(inside)); });
        double last = 0.0;
        bool seen = before.at(inside);
        const auto go_to = [&](double time, bool then) {
            // What does not fit together changes half way.
            const double seen_until = seen == then ? time : 0.5 * (last + time);
            times[k] += seen ? seen_until - last : then ? time - seen_until : 0.0;
            last = time;
        };
        for (const Moving& end : passing) {
            go_to(end.time_at(places[k]), !end.shows());
            seen = end.shows();
        }
        go_to(1.0, after.at(inside));
    }
}

bool same(const SeenAlong& a, const SeenAlong& b, double tolerance) {
    return a.first == b.first &&
           std::ranges::equal(a.changes, b.changes, [&](double x, double y) { return std::abs(x - y) <= tolerance; });
}

}  // namespace

bool SeenAlong::at(double place) const {
    return first != bool((std::ranges::upper_bound(changes, place) - changes.begin()) % 2);
}

void SeenAlong::go_on(double from, bool seen) {
    if (!begun_)
        first = seen;
    else if (seen != last_)
        changes.push_back(from);
    begun_ = true;
    last_ = seen;
}

void SeenAlong::go_on(const SeenAlong& other, double from, double to) {
    go_on(from, other.at(from));
    for (const double change : other.changes)
        if (from < change && change < to) go_on(change, !last_);
}

std::vector<Ramp> seen_over_time(In<SeenAlong> moments, double length, double still) {
    if (std::ranges::all_of(moments, [&](const SeenAlong& m) { return same(m, moments[0], still * length); }))
        return {};
    std::vector<double> places{0.0, length};
    for (const SeenAlong& moment : moments)
        for (const double change : moment.changes) places.push_back(std::clamp(change, 0.0, length));
    std::ranges::sort(places);
    places.erase(std::ranges::unique(places).begin(), places.end());
    std::vector<std::vector<Moving>> ends;
    for (std::size_t k = 1; k < moments.size(); ++k) ends.push_back(moving(moments[k - 1], moments[k]));
    std::vector<Ramp> ramps;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double between[] = {places[i - 1], places[i]}, inside = 0.5 * (between[0] + between[1]);
        double times[] = {0.0, 0.0};
        for (std::size_t k = 0; k < ends.size(); ++k)
            add_time(moments[k], moments[k + 1], ends[k], inside, between, times);
        const auto share = [&](double time) { return float(time / double(ends.size())); };
        ramps.push_back({between[0], between[1], share(times[0]), share(times[1])});
    }
    return ramps;
}

}  // namespace fovea::elision
