// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/found_places.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>

namespace fovea::elision {
namespace {

constexpr double reach = 8.0;    // reference pixels from a moved point to its line
constexpr double trusted = 4.0;  // reference pixels across, at which a place counts for 1 / e; to one right beside it
constexpr double along_beside = 2.5;  // reference pixels to one right beside a place, along the line
constexpr double far_along = 24.0;    // reference pixels between places of a line that are not neighbors
constexpr double same_way = 0.7;      // cosine between the directions of a line found again
constexpr double same_depth = 0.05;   // of the distance from the eye

/// Whether a place is right beside another one, from which it is so many pixels along its line and across it.
bool is_beside(const dvec2& from, const View& view) {
    return std::abs(from.x) <= along_beside * view.reference_scale &&
           std::abs(from.y) <= trusted * view.reference_scale;
}

/// Whether one place follows another one along a line, or at the end of it the line goes on in another piece.
bool go_on(const ViewLines& lines, const ViewLines::Place& a, const ViewLines::Place& b) {
    const double least = far_along * lines.pose.view.reference_scale;
    const auto to_end = [&](const ViewLines::Place& place) {
        const double first = lines.places[lines.rows.begin(place.piece)].arc,
                     last = lines.places[lines.rows.end(place.piece) - 1].arc;
        return std::min(place.arc - first, last - place.arc);
    };
    const double over_ends = to_end(a) + to_end(b);
    if (a.piece == b.piece) return std::abs(a.arc - b.arc) <= least || (lines.closed[a.piece] && over_ends <= least);
    return lines.path[a.piece] == lines.path[b.piece] && over_ends <= least;
}

}  // namespace

MovedPlaces::MovedPlaces(const ViewLines& now, const ViewLines& there) : now_(now), there_(there) {
    for (const Pose::Placed& placed : now.pose.placed) number_.push_back(there.pose.find(placed.id));
    points_ = parallel_map<Pose::Seen>(now.places.size(), [&](std::size_t j) {
        const ViewLines::Place& place = now.places[j];
        return there.pose.seen(place.point, now.pose.placed[place.placed], number_[place.placed]);
    });
}

bool MovedPlaces::is_inside(const Pose::Seen& point) const {
    return point.depth > 0.0 && point.px.x >= 0.0 && point.px.y >= 0.0 && point.px.x <= there_.pose.view.width &&
           point.px.y <= there_.pose.view.height;
}

/// The nearest places that accept(place, other, from) lets count: numbers of places, and pixels from the other one
/// along its line and across it.
template <typename Accept>
Array<FoundPlace> MovedPlaces::nearest(const Accept& accept) const {
    const double scale = there_.pose.view.reference_scale;
    Array<FoundPlace> found(now_.places.size());
    parallel_for(found.size(), 256, [&](std::size_t j) {
        const ViewLines::Place& place = now_.places[j];
        const Pose::Seen& point = points_[j];
        FoundPlace& best = found[j] = {};
        if (std::isnan(point.depth)) return;
        const Index first = now_.rows.begin(place.piece), last = now_.rows.end(place.piece) - 1;
        const Pose::Seen &before = points_[std::max<std::size_t>(j, first + 1) - 1],
                         &after = points_[std::min<std::size_t>(j + 1, last)];
        const dvec2 across = after.px - before.px;
        const double length = glm::length(across);
        const dvec2 way = std::isnan(before.depth + after.depth) || length == 0.0 ? place.way : across / length;
        double nearest = reach * scale;
        there_.grid->near(point.px, [&](std::size_t k) {
            const ViewLines::Place& other = there_.places[k];
            const double away = glm::distance(point.px, other.px), along = glm::dot(way, other.way);
            if (away >= nearest || std::abs(along) < same_way || other.placed != number_[place.placed] ||
                std::abs(other.depth - point.depth) > same_depth * std::abs(point.depth))
                return;
            const dvec2 from(glm::dot(point.px - other.px, other.way), cross(other.way, point.px - other.px));
            if (!accept(j, k, from)) return;
            nearest = away;
            const double aside = from.y / (trusted * scale);
            best = {Index(k), from.x, std::exp(-aside * aside), along > 0.0};
        });
        best.inside = is_inside(point);
    });
    return found;
}

Array<FoundPlace> MovedPlaces::found() const {
    return nearest([&](std::size_t j, std::size_t k, const dvec2&) {
        return (now_.places[j].kinds & there_.places[k].kinds) != 0;
    });
}

Array<FoundPlace> MovedPlaces::beside(In<std::uint8_t> counts) const {
    return nearest(
        [&](std::size_t, std::size_t k, const dvec2& from) { return counts[k] && is_beside(from, there_.pose.view); });
}

Array<std::uint8_t> are_beside(const ViewLines& lines, In<std::uint8_t> counts) {
    const auto found = MovedPlaces(lines, lines).nearest([&](std::size_t j, std::size_t k, const dvec2& from) {
        return counts[k] && is_beside(from, lines.pose.view) && !go_on(lines, lines.places[j], lines.places[k]);
    });
    return parallel_map<std::uint8_t>(found.size(), [&](std::size_t j) { return found[j].place != none; });
}

}  // namespace fovea::elision
