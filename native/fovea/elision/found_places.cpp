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

/// A point of the surface in another frame; a depth that is not a number: it is not there.
struct Moved {
    dvec2 px;
    double depth;
};

bool is_inside(const Moved& moved, const View& view) {
    return moved.depth > 0.0 && moved.px.x >= 0.0 && moved.px.y >= 0.0 && moved.px.x <= view.width &&
           moved.px.y <= view.height;
}

/// Whether a place is right beside another one, from which it is so many pixels along its line and across it.
bool is_beside(const dvec2& from, const View& view) {
    return std::abs(from.x) <= along_beside * view.reference_scale &&
           std::abs(from.y) <= trusted * view.reference_scale;
}

/// Whether one place follows another one along a line, or at the end of it the line goes on in another piece.
bool go_on(const ViewLines& lines, const ViewLines::Place& a, const ViewLines::Place& b) {
    const double least = far_along * lines.view.reference_scale;
    const auto to_end = [&](const ViewLines::Place& place) {
        const double first = lines.places[lines.rows.begin(place.piece)].arc,
                     last = lines.places[lines.rows.end(place.piece) - 1].arc;
        return std::min(place.arc - first, last - place.arc);
    };
    const double over_ends = to_end(a) + to_end(b);
    if (a.piece == b.piece) return std::abs(a.arc - b.arc) <= least || (lines.closed[a.piece] && over_ends <= least);
    return lines.path[a.piece] == lines.path[b.piece] && over_ends <= least;
}

/// The nearest places that accept(place, other, from) lets count: numbers of places, and pixels from the other one
/// along its line and across it.
template <typename Accept>
Array<FoundPlace> nearest_places(const ViewLines& now, const ViewLines& there, const Accept& accept) {
    const Carrier carrier(now, there);
    const double scale = there.view.reference_scale;
    const Array<Moved> moved = parallel_map<Moved>(now.places.size(), [&](std::size_t j) {
        if (carrier.number(now.places[j]) == none) return Moved{dvec2(0.0), NAN};
        const dvec3 position = carrier.position(now.places[j]);
        const dvec4 clip = there.view.view_to_clip * dvec4(position, 1.0);
        const dvec2 px = to_pixels(there.view, clip);
        const bool seen = clip.w > 0.0 && std::abs(px.x) < 1e6 && std::abs(px.y) < 1e6;
        return Moved{px, seen ? -position.z : NAN};
    });
    Array<FoundPlace> found(now.places.size());
    parallel_for(found.size(), 256, [&](std::size_t j) {
        const ViewLines::Place& place = now.places[j];
        FoundPlace& best = found[j] = {};
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
                std::abs(other.depth - moved[j].depth) > same_depth * std::abs(moved[j].depth))
                return;
            const dvec2 from(glm::dot(moved[j].px - other.px, other.way), cross(other.way, moved[j].px - other.px));
            if (!accept(j, k, from)) return;
            nearest = away;
            const double aside = from.y / (trusted * scale);
            best = {Index(k), from.x, std::exp(-aside * aside), along > 0.0};
        });
        best.inside = is_inside(moved[j], there.view);
    });
    return found;
}

}  // namespace

Array<FoundPlace> found_places(const ViewLines& now, const ViewLines& there) {
    return nearest_places(now, there, [&](std::size_t j, std::size_t k, const dvec2&) {
        return (now.places[j].kinds & there.places[k].kinds) != 0;
    });
}

Array<FoundPlace> places_beside(const ViewLines& now, const ViewLines& there, In<std::uint8_t> counts) {
    return nearest_places(now, there, [&](std::size_t, std::size_t k, const dvec2& from) {
        return counts[k] && is_beside(from, there.view);
    });
}

Array<std::uint8_t> are_beside(const ViewLines& lines, In<std::uint8_t> counts) {
    const auto found = nearest_places(lines, lines, [&](std::size_t j, std::size_t k, const dvec2& from) {
        return counts[k] && is_beside(from, lines.view) && !go_on(lines, lines.places[j], lines.places[k]);
    });
    return parallel_map<std::uint8_t>(found.size(), [&](std::size_t j) { return found[j].place != none; });
}

}  // namespace fovea::elision
