// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/marked_lines.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>

namespace fovea::stroke {
namespace {

constexpr std::uint64_t far = 509;  // periods by which lines may begin elsewhere
constexpr std::size_t around = 6;   // places to each side over which the side that the surface faces is averaged
constexpr double clear = 0.3;       // sine of its angle to the line

/// Twice the normal of what lies on both sides of a place, object space; outward.
dvec3 normal_at(const Surface& surface, Index place) {
    if (!surface.is_edge(place))
        return dvec3(vec3(surface.facet_plane[surface.triangle_facet[surface.triangle_at(place)]]));
    dvec3 sum(0.0);
    for (const mesh::EdgeSide side : surface.sides(place)) sum += dvec3(vec3(surface.facet_plane[side.facet()]));
    return sum;
}

/// Per place: 1 where the surface faces the right of the line, else -1: however a path is chained, that is the same.
/// Where it faces along the line it is as before.
std::vector<double> ways_of(In<ViewLines::Place> places, const dmat4& object_to_view, const Surface& surface,
                            const ClippedPaths& clipped, In<Index> on) {
    const dmat3 normals = glm::transpose(glm::inverse(dmat3(object_to_view)));
    std::vector<double> sums{0.0};  // of how much it does
    for (const ViewLines::Place& place : places) {
        const Index i = clipped.segment_at(place.piece, place.arc);
        const dvec2 normal(unit_or_zero(normals * normal_at(surface, on[clipped.source[i]])));
        const double side = cross(normal, place.way);
        sums.push_back(sums.back() + (std::isfinite(side) ? side : 0.0));
    }
    const std::size_t size = places.size();
    double way = sums.back() < 0.0 ? -1.0 : 1.0;
    std::vector<double> ways(size);
    for (std::size_t k = 0; k < size; ++k) {
        const std::size_t begin = std::max(k, around) - around, end = std::min(k + around + 1, size);
        if (-way * (sums[end] - sums[begin]) > clear * double(end - begin)) way = -way;
        ways[k] = way;
    }
    return ways;
}

/// Sets where the marks of a line are. `own[0]` is where the first one is.
void go_along(In<ViewLines::Place> places, const std::vector<double>& ways, bool closed, double period,
              std::span<double> own) {
    const std::size_t size = places.size();
    for (std::size_t k = 1; k < size; ++k) own[k] = own[k - 1] + ways[k] * (places[k].arc - places[k - 1].arc);
    if (!closed) return;
    // One that runs around has at least one period; one that comes back as it went may have none.
    const double length = places[size - 1].arc - places[0].arc, turn = own[size - 1] - own[0];
    const double least = std::abs(turn) > 0.5 * length ? 1.0 : 0.0;
    const double whole = std::copysign(std::max(least, std::round(std::abs(turn) / period)) * period, turn);
    for (std::size_t k = 0; k < size; ++k) own[k] += (whole - turn) * double(k) / double(size - 1);
}

}  // namespace

std::shared_ptr<const Array<double>> HandedOn::find(std::uint64_t number) const {
    const std::scoped_lock lock(mutex_);
    const auto at = kept_.find(number);
    return at == kept_.end() ? nullptr : at->second;
}

void HandedOn::keep(std::uint64_t number, std::shared_ptr<const Array<double>> values) {
    const std::scoped_lock lock(mutex_);
    if (kept_.size() == most) kept_.clear();
    kept_.emplace(number, std::move(values));
}

std::uint64_t MarkedLines::content() const {
    Array<Index> sizes;
    Array<dvec2> px;
    for (Index q = 0; q < period.size(); ++q) {
        if (period[q] == 0.0) continue;
        sizes.push_back(lines->rows.size(q));
        for (Index j = lines->rows.begin(q); j < lines->rows.end(q); ++j) px.push_back(lines->places[j].px);
    }
    if (px.empty()) return 0;
    const Array<double> marks = packed(own);
    const std::uint64_t hash = hash_of(In<double>(marks), hash_of(In<Index>(sizes)));
    return std::max<std::uint64_t>(hash_of(In<dvec2>(px), hash), 1);
}

Array<double> MarkedLines::packed(In<double> values) const {
    Array<double> made;
    for (std::size_t j = 0; j < values.size(); ++j)
        if (period[lines->places[j].piece] > 0.0) made.push_back(values[j]);
    return made;
}

Array<double> MarkedLines::unpacked(In<double> packed) const {
    Array<double> made(own.size(), 0.0);
    std::size_t next = 0;
    for (std::size_t j = 0; j < made.size(); ++j) {
        if (period[lines->places[j].piece] == 0.0) continue;
        check(next < packed.size(), "marks: too few for these lines");
        made[j] = packed[next++];
    }
    check(next == packed.size(), "marks: too many for these lines");
    return made;
}

MarkedLines marked_lines(std::shared_ptr<const ViewLines> lines, const ClippedPaths& clipped, const Paths& paths,
                         const Scene& scene, In<double> period) {
    MarkedLines made;
    made.own.assign(lines->places.size(), 0.0);
    made.period.assign(lines->rows.count(), 0.0);
    parallel_for(lines->rows.count(), 64, [&](std::size_t q) {
        const Index begin = lines->rows.begin(Index(q)), size = lines->rows.size(Index(q)), path = lines->path[q];
        const double length = period[paths.line_set[path]];
        if (size == 0 || length == 0.0) return;
        made.period[q] = length;
        const In<ViewLines::Place> places(lines->places.data() + begin, size);
        const std::span<double> own(made.own.data() + begin, size);
        const dmat4& object_to_view = lines->pose.placed[places[0].placed].object_to_view;
        const Surface& surface = *scene.placements[paths.placement[path]].surface;
        own[0] = double(paths.id[path] % far) * length;
        go_along(places, ways_of(places, object_to_view, surface, clipped, paths.place), lines->closed[q], length, own);
    });
    static std::atomic<std::uint64_t> count{0};
    made.number = ++count;
    made.lines = std::move(lines);
    return made;
}

}  // namespace fovea::stroke
