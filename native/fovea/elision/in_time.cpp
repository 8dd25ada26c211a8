// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/in_time.h>

#include <algorithm>
#include <cstdlib>

#include <fovea/base/check.h>
#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/elision/own_band.h>
#include <fovea/focus/at_samples.h>

namespace fovea::elision {
namespace {

using Part = ShownLines::Part;
using Sample = ShownLines::Sample;

/// Keys of places on the paths of a frame (ShownLines::Key).
class Keys {
   public:
    Keys(const Paths& paths, const Scene& scene) : paths_(paths), scene_(scene) {}

    /// The part that contains the segment from a point of a path.
    Part part(Index path, Index point) const {
        const Placement& placement = scene_.placements[paths_.placement[path]];
        const Index end = paths_.rows.end(path) - 1;
        if (!on_edges(path)) return {paths_.id[path], path, 0.0, paths_.arc_obj[end]};
        const bool ahead = paths_.edge_t[point] < 0.5f;
        const double first = paths_.arc_obj[point], last = paths_.arc_obj[point + 1];
        return {hash_numbers(placement.id, paths_.place[point]), path, ahead ? first : last, ahead ? last : first};
    }

    /// Parts of some paths, ascending.
    Array<Part> parts(In<Index> some) const {
        Array<Index> starts;
        for (const Index p : some) starts.push_back(on_edges(p) ? paths_.rows.size(p) - 1 : 1);
        counts_to_offsets(starts);
        Array<Part> found(starts.back());
        parallel_for(some.size(), 256, [&](std::size_t k) {
            for (Index i = starts[k]; i < starts[k + 1]; ++i)
                found[i] = part(some[k], paths_.rows.begin(some[k]) + i - starts[k]);
        });
        parallel_sort(found.begin(), found.end(), [](const Part& a, const Part& b) {
            return a.key != b.key ? a.key < b.key : a.path != b.path ? a.path < b.path : a.from < b.from;
        });
        return found;
    }

   private:
    bool on_edges(Index path) const {
        const Placement& placement = scene_.placements[paths_.placement[path]];
        return paths_.place[paths_.rows.begin(path)] < placement.surface->edges.size();
    }

    const Paths& paths_;
    const Scene& scene_;
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

/// Lookup of elision opacities in another frame.
class Frame {
   public:
    explicit Frame(const ShownLines& lines) : lines_(lines) {}

    /// Elision opacity at the place of another frame's sample; below 0 if not in this picture.
    double at(const Sample& sample, bool hidden) {
        if (part_ == lines_.parts.end() || part_->key != sample.key) part_ = find(sample.key);
        if (part_ == lines_.parts.end()) return ShownLines::unseen;
        const double arc = glm::mix(part_->from, part_->to, sample.share);
        const auto stretches = std::ranges::equal_range(lines_.path, part_->path);
        for (auto s = stretches.begin(); s != stretches.end(); ++s) {
            const Index stretch = Index(s - lines_.path.begin());
            if (bool(lines_.hidden[stretch]) != hidden) continue;
            const double shown = on(stretch, arc);
            if (shown >= 0.0) return shown;
        }
        return ShownLines::unseen;
    }

   private:
    /// The part with a key; end() unless it is unique.
    Array<Part>::const_iterator find(ShownLines::Key key) const {
        const auto same = std::ranges::equal_range(lines_.parts, key, {}, &Part::key);
        return same.size() == 1 ? same.begin() : lines_.parts.end();
    }

    /// Elision opacity at an arc length of a stretch.
    double on(Index stretch, double arc) const {
        const auto begin = lines_.samples.begin() + lines_.rows.begin(stretch);
        const auto end = lines_.samples.begin() + lines_.rows.end(stretch);
        const auto after = std::ranges::upper_bound(begin, end, arc, {}, &Sample::arc);
        if (after == begin) return begin->arc - arc <= begin->reach ? begin->shown : ShownLines::unseen;
        const auto before = after - 1;
        if (after == end) return arc - before->arc <= before->reach ? before->shown : ShownLines::unseen;
        if (before->shown < 0.0f || after->shown < 0.0f) return ShownLines::unseen;
        return glm::mix(double(before->shown), double(after->shown), (arc - before->arc) / (after->arc - before->arc));
    }

    const ShownLines& lines_;
    Array<Part>::const_iterator part_ = lines_.parts.end();
};

}  // namespace

ShownLines shown_lines(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const Runs& runs,
                       In<float> shown, int width, int height) {
    check(shown.size() == clipped.samples, "smoothing in time: one opacity per atlas sample expected");
    // Only the samples of each run and their positions are used, not their bands.
    const Array<Index> ranks(runs.size(), 0);
    const Array<float> widths(clipped.samples, 0.0f);
    const OwnBands own = own_bands(clipped, runs, ranks, widths, 1.0f);
    const Array<OnPath> places = places_of_samples(clipped, paths);
    const Keys keys(paths, scene);

    const auto path_of = [&](Index r) { return clipped.path[runs.piece[r]]; };
    Array<Index> order;  // run numbers, by path
    for (Index r = 0; r < runs.size(); ++r)
        if (own.runs.size(r) > 0 && !paths.of_view[path_of(r)]) order.push_back(r);
    std::ranges::stable_sort(order, {}, path_of);

    ShownLines lines;
    lines.rows.offsets.clear();
    for (const Index r : order) {
        lines.path.push_back(path_of(r));
        lines.hidden.push_back(runs.invisibility[r] != 0);
        lines.rows.offsets.push_back(own.runs.size(r));
    }
    counts_to_offsets(lines.rows.offsets);
    lines.samples.resize(lines.rows.offsets.back());
    parallel_for(order.size(), 64, [&](std::size_t s) {
        Sample* sample = &lines.samples[lines.rows.begin(Index(s))];
        for (Index k = own.runs.begin(order[s]); k < own.runs.end(order[s]); ++k, ++sample) {
            const OnPath& place = places[own.sample[k]];
            const vec4& at = own.place[k];
            const bool inside = at.x >= 0.0f && at.x < float(width) && at.y >= 0.0f && at.y < float(height);
            const Part part = keys.part(lines.path[s], place.point);
            const double length = part.to - part.from;
            *sample = {own.sample[k], part.key,    length != 0.0 ? (place.arc - part.from) / length : 0.0,
                       place.arc,     place.reach, inside ? shown[own.sample[k]] : ShownLines::unseen};
        }
    });
    Array<Index> drawn(lines.path);
    const auto rest = std::ranges::unique(drawn);
    drawn.erase(rest.begin(), rest.end());
    lines.parts = keys.parts(drawn);
    return lines;
}

Array<float> smoothed_in_time(In<float> shown, const ShownLines& now, In<FrameNear> near, int frames) {
    const bool fits = std::ranges::all_of(now.samples, [&](const Sample& s) { return s.number < shown.size(); });
    check(fits, "smoothing in time: lines of another frame");
    for (const auto& [away, lines] : near)
        check(away != 0 && std::abs(away) <= frames, "smoothing in time: a frame is not near by");
    Array<float> smooth(shown.begin(), shown.end());
    parallel_for(now.path.size(), 64, [&](std::size_t stretch) {
        std::vector<Frame> others;
        for (const auto& [away, lines] : near) others.emplace_back(*lines);
        for (Index i = now.rows.begin(Index(stretch)); i < now.rows.end(Index(stretch)); ++i) {
            const Sample& sample = now.samples[i];
            if (sample.shown < 0.0f) continue;
            double weight = frames + 1.0, sum = weight * sample.shown;
            for (std::size_t k = 0; k < near.size(); ++k) {
                const double there = others[k].at(sample, now.hidden[stretch]);
                if (there < 0.0) continue;
                weight += frames + 1.0 - std::abs(near[k].first);
                sum += (frames + 1.0 - std::abs(near[k].first)) * there;
            }
            smooth[sample.number] = float(sum / weight);
        }
    });
    return smooth;
}

}  // namespace fovea::elision
