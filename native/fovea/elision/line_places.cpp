// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/line_places.h>

#include <algorithm>
#include <unordered_map>

#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/elision/own_band.h>
#include <fovea/focus/at_samples.h>

namespace fovea::elision {
namespace {

using Part = LinePlaces::Part;
using Sample = LinePlaces::Sample;

/// The parts of some paths.
class Parts {
   public:
    /// `some`: paths, ascending.
    Parts(const Paths& paths, const Scene& scene, In<Index> some) : paths_(paths), scene_(scene) {
        std::unordered_map<const Surface*, std::uint64_t> known;
        for (const Placement& placement : scene.placements) {
            const auto [at, fresh] = known.try_emplace(placement.surface.get());
            if (fresh) at->second = hash_of(In<mesh::Edge>(placement.surface->edges));
            object_.push_back(hash_numbers(placement.id, at->second));
        }
        first_.resize(paths.count());
        Index count = 0;
        for (const Index p : some) {
            first_[p] = count;
            count += on_edges(p) ? paths.rows.size(p) - 1 : 1;
        }
        Array<Numbered> found(count);
        parallel_for(some.size(), 256, [&](std::size_t k) {
            const Index p = some[k], begin = paths.rows.begin(p);
            const Index size = on_edges(p) ? paths.rows.size(p) - 1 : 1;
            for (Index i = 0; i < size; ++i) found[first_[p] + i] = {part(p, begin + i), first_[p] + i};
        });
        parallel_sort(found.begin(), found.end(), [](const Numbered& m, const Numbered& n) {
            const Part &a = m.part, &b = n.part;
            return a.key != b.key ? a.key < b.key : a.path != b.path ? a.path < b.path : a.from < b.from;
        });
        sorted.resize(count);
        place_.resize(count);
        parallel_for(count, 1024, [&](std::size_t i) {
            sorted[i] = found[i].part;
            place_[found[i].number] = Index(i);
        });
    }

    Array<Part> sorted;  ///< by key

    /// Index into `sorted` of the part that contains the segment from a point of a path.
    Index of(Index path, Index point) const {
        return place_[first_[path] + (on_edges(path) ? point - paths_.rows.begin(path) : 0)];
    }

   private:
    struct Numbered {
        Part part;
        Index number;
    };

    bool on_edges(Index path) const {
        const Placement& placement = scene_.placements[paths_.placement[path]];
        return placement.surface->is_edge(paths_.place[paths_.rows.begin(path)]);
    }

    Part part(Index path, Index point) const {
        const std::uint64_t object = object_[paths_.placement[path]];
        const Index end = paths_.rows.end(path) - 1;
        if (!on_edges(path)) return {hash_numbers(object, paths_.id[path]), path, 0.0, paths_.arc_obj[end]};
        const bool ahead = paths_.edge_t[point] < 0.5f;
        const double first = paths_.arc_obj[point], last = paths_.arc_obj[point + 1];
        return {hash_numbers(object, paths_.place[point]), path, ahead ? first : last, ahead ? last : first};
    }

    const Paths& paths_;
    const Scene& scene_;
    Array<std::uint64_t> object_;  // per placement: hash of its id and its edges
    Array<Index> first_;           // per path: number of its first part, as they are before they are sorted
    Array<Index> place_;           // per number: index into `sorted`
};

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
    Parts parts(paths, scene, drawn);
    lines.samples.resize(lines.rows.offsets.back());
    parallel_for(order.size(), 64, [&](std::size_t s) {
        Sample* sample = &lines.samples[lines.rows.begin(Index(s))];
        for (Index k = own.runs.begin(order[s]); k < own.runs.end(order[s]); ++k, ++sample) {
            const OnPath& place = places[own.sample[k]];
            const vec4& at = own.place[k];
            const bool inside = at.x >= 0.0f && at.x < float(width) && at.y >= 0.0f && at.y < float(height);
            const Index number = parts.of(lines.path[s], place.point);
            const Part& part = parts.sorted[number];
            const double length = part.to - part.from, share = length != 0.0 ? (place.arc - part.from) / length : 0.0;
            *sample = {own.sample[k], number, share, place.arc, place.reach, inside};
        }
    });
    lines.parts = std::move(parts.sorted);
    return lines;
}

MatchedPlaces::MatchedPlaces(const LinePlaces& now, const LinePlaces& there) : there_(there) {
    part_.reserve(now.parts.size());
    auto at = there.parts.begin();
    const auto end = there.parts.end();
    for (const Part& part : now.parts) {
        while (at != end && at->key < part.key) ++at;
        const bool one = at != end && at->key == part.key && (at + 1 == end || (at + 1)->key != part.key);
        part_.push_back(one ? Index(at - there.parts.begin()) : none);
    }
    first_stretch_.assign(there.path.empty() ? 1 : there.path.back() + 1, 0);
    for (const Index path : there.path) ++first_stretch_[path];
    counts_to_offsets(first_stretch_);
}

std::optional<MatchedPlaces::Place> MatchedPlaces::at(const LinePlaces::Sample& sample, bool hidden) const {
    if (part_[sample.part] == none) return {};
    const Part& part = there_.parts[part_[sample.part]];
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
