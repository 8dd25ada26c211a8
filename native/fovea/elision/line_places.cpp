// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/line_places.h>

#include <algorithm>

#include <fovea/base/parallel.h>
#include <fovea/elision/own_band.h>
#include <fovea/focus/at_samples.h>

namespace fovea::elision {
namespace {

using Sample = LinePlaces::Sample;

/// Position of an atlas sample on its path: segment from `point`, arc length, and range of validity.
struct OnPath {
    Index point;
    double arc, reach;
};

Array<OnPath> places_of_samples(const ClippedPaths& clipped, const Paths& paths) {
    return at_samples(clipped, [&](const SamplePlace& at) {
        const Index source = clipped.source[at.point];
        const double from = paths.arc_obj[source], way = paths.arc_obj[source + 1] - from;
        const double begin = clipped.source_t[at.point];
        const double end = clipped.source[at.point + 1] == source ? clipped.source_t[at.point + 1] : 1.0;
        return OnPath{source, from + glm::mix(begin, end, double(at.in_space)) * way,
                      0.5 * (end - begin) * way / clipped.sample_count[at.point]};
    });
}

}  // namespace

LinePlaces line_places(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const Runs& runs, int width,
                       int height) {
    // Only the samples of each run and their positions are used, not their bands.
    const Array<Index> ranks(runs.size(), 0);
    const Array<float> widths(clipped.samples, 0.0f);
    const OwnBands own = own_bands(clipped, runs, ranks, widths, 1.0f);
    const Array<OnPath> places = places_of_samples(clipped, paths);

    const auto path_of = [&](Index r) { return clipped.path[runs.piece[r]]; };
    Array<Index> order;  // run numbers, by path
    for (Index r = 0; r < runs.size(); ++r)
        if (own.runs.size(r) > 0 && !paths.of_view[path_of(r)]) order.push_back(r);
    std::ranges::stable_sort(order, {}, path_of);

    LinePlaces lines;
    lines.rows.offsets.clear();
    for (const Index r : order) {
        lines.path.push_back(path_of(r));
        lines.hidden.push_back(runs.invisibility[r] != 0);
        lines.rows.offsets.push_back(own.runs.size(r));
    }
    counts_to_offsets(lines.rows.offsets);
    Array<Index> drawn(lines.path);
    const auto rest = std::ranges::unique(drawn);
    drawn.erase(rest.begin(), rest.end());
    LineParts parts(paths, scene, drawn);
    lines.samples.resize(lines.rows.offsets.back());
    parallel_for(order.size(), 64, [&](std::size_t s) {
        Sample* sample = &lines.samples[lines.rows.begin(Index(s))];
        for (Index k = own.runs.begin(order[s]); k < own.runs.end(order[s]); ++k, ++sample) {
            const OnPath& place = places[own.sample[k]];
            const vec4& at = own.place[k];
            const bool inside = at.x >= 0.0f && at.x < float(width) && at.y >= 0.0f && at.y < float(height);
            const Index number = parts.of(lines.path[s], place.point);
            const LinePart& part = parts.sorted[number];
            const double length = part.to - part.from, share = length != 0.0 ? (place.arc - part.from) / length : 0.0;
            *sample = {own.sample[k], number, share, place.arc, place.reach, inside};
        }
    });
    lines.parts = std::move(parts.sorted);
    return lines;
}

MatchedPlaces::MatchedPlaces(const LinePlaces& now, const LinePlaces& there)
    : there_(there), part_(matched_parts(now.parts, there.parts)) {
    first_stretch_.assign(there.path.empty() ? 1 : there.path.back() + 1, 0);
    for (const Index path : there.path) ++first_stretch_[path];
    counts_to_offsets(first_stretch_);
}

std::optional<MatchedPlaces::Place> MatchedPlaces::at(const LinePlaces::Sample& sample, bool hidden) const {
    if (part_[sample.part] == none) return {};
    const LinePart& part = there_.parts[part_[sample.part]];
    const double arc = glm::mix(part.from, part.to, sample.share);
    for (Index stretch = first_stretch_[part.path]; stretch < first_stretch_[part.path + 1]; ++stretch) {
        if (bool(there_.hidden[stretch]) != hidden) continue;
        if (const auto found = on(stretch, arc)) return found;
    }
    return {};
}

std::optional<MatchedPlaces::Place> MatchedPlaces::on(Index stretch, double arc) const {
    const auto begin = there_.samples.begin() + there_.rows.begin(stretch);
    const auto end = there_.samples.begin() + there_.rows.end(stretch);
    auto after = std::ranges::upper_bound(begin, end, arc, {}, &Sample::arc), before = after;
    double share = 0.0;
    if (after == begin) {
        if (begin->arc - arc > begin->reach) return {};
    } else if (--before, after == end) {
        after = before;
        if (arc - before->arc > before->reach) return {};
    } else {
        share = (arc - before->arc) / (after->arc - before->arc);
    }
    if (!before->inside || !after->inside) return {};
    return Place{Index(before - there_.samples.begin()), Index(after - there_.samples.begin()), share};
}

}  // namespace fovea::elision
