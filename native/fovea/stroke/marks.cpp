// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/marks.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <fovea/base/check.h>
#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/elision/found_places.h>

namespace fovea::stroke {
namespace {

constexpr double least_trust = 0.2;  // below it a place is nowhere
constexpr double stiff = 0.02;       // how little a place gives in to its neighbors, where it has no value itself

double wrapped(double difference, double period) { return difference - period * std::round(difference / period); }

double slope_of(In<double> values, const ViewLines& lines, Index place) {
    return slope_at(lines, place, [&](Index j) { return values[j]; });
}

/// Differences along a line that are known up to whole periods, as one that goes on from place to place: by that many
/// periods from what they were as most of it agrees on. `trust` 0: unknown.
void go_on(std::span<double> differences, In<double> trust, double period) {
    std::map<double, double> agree;  // trust by periods
    double last = NAN;
    for (std::size_t k = 0; k < differences.size(); ++k) {
        if (trust[k] == 0.0) continue;
        const double was = differences[k];
        if (!std::isnan(last)) differences[k] = last + wrapped(was - last, period);
        last = differences[k];
        agree[std::round((was - last) / period)] += trust[k];
    }
    const auto most = std::ranges::max_element(agree, {}, [](const auto& each) { return each.second; });
    for (double& difference : differences) difference += most->first * period;
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

Array<double> handed_on(const MarkedLines& now, const MarkedLines& there, In<double> values) {
    check(values.size() == there.own.size(), "marks: one per place of the other lines expected");
    const Array<FoundPlace> found = MovedPlaces(*now.lines, *there.lines).found();
    Array<double> made(now.own.begin(), now.own.end());
    parallel_for(now.period.size(), 64, [&](std::size_t q) {
        const Index begin = now.lines->rows.begin(Index(q)), size = now.lines->rows.size(Index(q));
        if (now.period[q] == 0.0) return;
        const std::span<double> out(made.data() + begin, size);
        std::vector<double> trust(size);
        // Arc length that ascends where the values do; else, where its own do.
        std::vector<double> along(size);
        bool any = false;
        for (Index k = 0; k < size; ++k) {
            const double step = now.own[begin + k] - now.own[begin + std::max(k, Index(1)) - 1];
            const FoundPlace& at = found[begin + k];
            const double period = at.place == none ? 0.0 : there.period[there.lines->places[at.place].piece];
            const bool counts = period > 0.0 && at.trust >= least_trust;
            const double slope = counts ? slope_of(values, *there.lines, at.place) : 0.0;
            const double ascent = at.same ? slope : -slope;
            along[k] = (k > 0 ? along[k - 1] : now.own[begin]) + (counts ? std::copysign(step, ascent) : step);
            out[k] = counts ? (values[at.place] + slope * at.beyond) * (now.period[q] / period) - along[k] : 0.0;
            trust[k] = counts ? at.trust : 0.0;
            any |= counts;
        }
        if (any) {
            go_on(out, trust, now.period[q]);
            fill(out, trust);
        }
        for (Index k = 0; k < size; ++k) out[k] += along[k];
        const double open = now.lines->closed[q] ? wrapped(out[size - 1] - out[0], now.period[q]) : 0.0;
        for (Index k = 0; k < size; ++k) out[k] -= open * k / (size - 1);
    });
    return made;
}

namespace {

/// Marks that are at `last`, on the way to the nearest ones of those that are at `next`. Where they lie half a period
/// apart, one of them comes or goes.
Array<double> on_the_way(const MarkedLines& of, In<double> last, In<double> next, double share) {
    return parallel_map<double>(last.size(), [&](std::size_t j) {
        const double period = of.period[of.lines->places[j].piece];
        if (period == 0.0) return 0.0;
        if (slope_of(last, *of.lines, Index(j)) * slope_of(next, *of.lines, Index(j)) < 0.0)
            return share < 0.5 ? last[j] : next[j];
        return last[j] + share * wrapped(next[j] - last[j], period);
    });
}

/// Values of the places of the frame at 0, handed on from a key at another offset, frame by frame; then to a moment of
/// it, unless that is null. Each frame of the way keeps its own: the next frames ask for them again.
Array<double> handed_along(const std::map<int, const MarkedLines*>& lines, int key, const MarkedLines* moment) {
    const MarkedLines* here = lines.at(key);
    auto values = std::make_shared<const Array<double>>(here->own);
    std::uint64_t chain = here->number;
    while (key != 0) {
        const MarkedLines* const before = here;
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

Marks marks_in_time(std::shared_ptr<const MarkedLines> now, In<MarkedNear> near, int since_key, int frames,
                    In<double> baked) {
    std::map<int, const MarkedLines*> lines;
    for (const auto& [away, of] : near)
        if (of) lines.emplace(away, of.get());
    const bool is_itself = lines.emplace(0, now.get()).second;
    const MarkedLines* const moment = is_itself ? nullptr : now.get();
    Marks marks{now, {}, {}, {}, 0.0};
    if (!baked.empty()) {
        const MarkedLines& itself = *lines[0];
        const Array<double> of_places = itself.unpacked(baked);
        marks.last = moment ? handed_on(*moment, itself, of_places) : of_places;
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
