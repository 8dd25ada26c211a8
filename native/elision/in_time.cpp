#include "elision/in_time.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "base/check.h"
#include "base/parallel.h"
#include "elision/own_band.h"
#include "focus/each_sample.h"

namespace fovea {
namespace {

/// Per path: whether it can be told from all others in every frame.
Array<std::uint8_t> told_apart(const Paths& paths) {
    Array<Index> order;
    for (Index p = 0; p < paths.count(); ++p)
        if (!paths.of_view[p]) order.push_back(p);
    std::ranges::sort(order, {}, [&](Index p) { return paths.id[p]; });
    Array<std::uint8_t> told(paths.count(), 0);
    const auto same = [&](std::size_t a, std::size_t b) { return paths.id[order[a]] == paths.id[order[b]]; };
    for (std::size_t k = 0; k < order.size(); ++k)
        told[order[k]] = !(k > 0 && same(k - 1, k)) && !(k + 1 < order.size() && same(k, k + 1));
    return told;
}

/// Where samples are on their paths.
struct OnPath {
    double place, reach;
};

Array<OnPath> places_of_samples(const ClippedPaths& clipped, const Paths& paths) {
    Array<Index> piece_of_point(clipped.px.size());
    parallel_for(clipped.path.size(), [&](std::size_t q) {
        std::fill(piece_of_point.begin() + clipped.pieces.begin(Index(q)),
                  piece_of_point.begin() + clipped.pieces.end(Index(q)), Index(q));
    });
    Array<OnPath> places(clipped.samples);
    each_sample(clipped, [&](const SamplePlace& at) {
        const Index path = clipped.path[piece_of_point[at.point]], source = clipped.source[at.point];
        const double length = paths.arc_obj[paths.rows.end(path) - 1];
        const double from = paths.arc_obj[source], way = paths.arc_obj[source + 1] - from;
        const double begin = clipped.source_t[at.point];
        const double end = clipped.source[at.point + 1] == source ? clipped.source_t[at.point + 1] : 1.0;
        const double per_length = length > 0.0 ? 1.0 / length : 0.0;
        places[at.sample] = {(from + glm::mix(begin, end, double(at.in_space)) * way) * per_length,
                             0.5 * (end - begin) * way * per_length / clipped.sample_count[at.point]};
    });
    return places;
}

/// What the samples of a stretch have seen so far of themselves.
struct Mean {
    double sum = 0.0, weight = 0.0;
};

/// Adds what one stretch of another frame shows of the places of a stretch that no stretch before it has shown.
void add(const ShownLines& now, Index stretch, const ShownLines& other, Index theirs, double weight,
         std::vector<Mean>& means, std::vector<std::uint8_t>& found) {
    const Index first = other.samples.begin(theirs), last = other.samples.end(theirs) - 1;
    const Index begin = now.samples.begin(stretch);
    Index k = first;
    for (Index i = begin; i < now.samples.end(stretch); ++i) {
        const double place = now.place[i];
        while (k < last && other.place[k + 1] <= place) ++k;
        if (found[i - begin] || other.shown[k] < 0.0f) continue;
        double shown = other.shown[k];
        if (place < other.place[k] || k == last) {
            if (std::abs(place - other.place[k]) > other.reach[k]) continue;
        } else {
            if (other.shown[k + 1] < 0.0f) continue;
            const double share = (place - other.place[k]) / (other.place[k + 1] - other.place[k]);
            shown = glm::mix(shown, double(other.shown[k + 1]), share);
        }
        found[i - begin] = 1;
        means[i - begin].sum += weight * shown;
        means[i - begin].weight += weight;
    }
}

}  // namespace

ShownLines shown_lines(const ClippedPaths& clipped, const Paths& paths, const Runs& runs, In<float> shown, int width,
                       int height) {
    check(shown.size() == clipped.samples, "smoothing in time: one opacity per atlas sample expected");
    const Array<Index> ranks(runs.size(), 0);
    const Array<float> widths(clipped.samples, 0.0f);
    const OwnBands own = own_bands(clipped, runs, ranks, widths);
    const Array<OnPath> places = places_of_samples(clipped, paths);
    const Array<std::uint8_t> told = told_apart(paths);

    Array<Index> order;  // of the runs
    for (Index r = 0; r < runs.size(); ++r)
        if (own.runs.size(r) > 0 && told[clipped.path[runs.piece[r]]]) order.push_back(r);
    const auto id = [&](Index r) { return paths.id[clipped.path[runs.piece[r]]]; };
    std::ranges::stable_sort(order, {}, id);

    ShownLines lines;
    lines.samples.offsets.clear();
    for (const Index r : order) {
        lines.id.push_back(id(r));
        lines.hidden.push_back(runs.invisibility[r] != 0);
        lines.samples.offsets.push_back(own.runs.size(r));
    }
    counts_to_offsets(lines.samples.offsets);
    const Index count = lines.samples.offsets.back();
    lines.sample.resize(count);
    lines.place.resize(count);
    lines.reach.resize(count);
    lines.shown.resize(count);
    parallel_for(
        order.size(),
        [&](std::size_t s) {
            Index i = lines.samples.begin(Index(s));
            for (Index k = own.runs.begin(order[s]); k < own.runs.end(order[s]); ++k, ++i) {
                const Index sample = own.sample[k];
                const vec4& at = own.place[k];
                const bool inside = at.x >= 0.0f && at.x < float(width) && at.y >= 0.0f && at.y < float(height);
                lines.sample[i] = sample;
                lines.place[i] = places[sample].place;
                lines.reach[i] = places[sample].reach;
                lines.shown[i] = inside ? shown[sample] : ShownLines::unseen;
            }
        },
        64);
    return lines;
}

Array<float> smoothed_in_time(In<float> shown, const ShownLines& now, In<FrameNear> near, int frames) {
    check(now.sample.empty() || std::ranges::max(now.sample) < shown.size(),
          "smoothing in time: lines of another frame");
    for (const FrameNear& frame : near)
        check(frame.away != 0 && std::abs(frame.away) <= frames, "smoothing in time: a frame is not near by");
    Array<float> smooth(shown.begin(), shown.end());
    parallel_for(
        now.id.size(),
        [&](std::size_t s) {
            const Index stretch = Index(s), begin = now.samples.begin(stretch), count = now.samples.size(stretch);
            std::vector<Mean> means(count);
            std::vector<std::uint8_t> found;
            for (Index i = 0; i < count; ++i) means[i] = {(frames + 1.0) * now.shown[begin + i], frames + 1.0};
            for (const FrameNear& frame : near) {
                found.assign(count, 0);
                const auto same = std::ranges::equal_range(frame.lines.id, now.id[s]);
                for (auto id = same.begin(); id != same.end(); ++id) {
                    const Index theirs = Index(id - frame.lines.id.begin());
                    if (frame.lines.hidden[theirs] == now.hidden[s])
                        add(now, stretch, frame.lines, theirs, frames + 1.0 - std::abs(frame.away), means, found);
                }
            }
            for (Index i = 0; i < count; ++i)
                if (now.shown[begin + i] >= 0.0f) smooth[now.sample[begin + i]] = float(means[i].sum / means[i].weight);
        },
        64);
    return smooth;
}

}  // namespace fovea
