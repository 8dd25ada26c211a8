// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/hysteresis.h>

#include <algorithm>

#include <fovea/base/parallel.h>
#include <fovea/mesh/triangle_sides.h>
#include <fovea/path/paths.h>

namespace fovea::path {
namespace {

/// Position on a chain: at fraction `t` from point `i` to the next.
struct Place {
    Index i;
    float t;
};

/// Interval of a chain. In a closed chain, point indices may continue past its end.
struct Stretch {
    Index chain;
    Place begin, end;
    bool closed;
    Index points() const { return end.i - begin.i + (end.t > 0.0f ? 2 : 1); }
};

/// One chain; in a closed one, point indices wrap around.
class Walk {
   public:
    Walk(const CurveChains& chains, Index chain)
        : chains_(chains),
          chain_(chain),
          first_(chains.rows.begin(chain)),
          points_(chains.rows.size(chain)),
          closed_(chains.closed[chain]) {}

    Index chain() const { return chain_; }
    Index points() const { return points_; }
    Index segments() const { return points_ - 1; }
    bool closed() const { return closed_; }
    /// The last point of a closed chain repeats the first, whose segment data is the valid one.
    Index at(Index i) const { return first_ + (closed_ ? i % segments() : i); }
    float strength(Index i) const { return chains_.strength[at(i)]; }
    vec3 point(const Place& p) const {
        return p.t > 0.0f ? glm::mix(chains_.point[at(p.i)], chains_.point[at(p.i + 1)], p.t) : chains_.point[at(p.i)];
    }
    float strength(const Place& p) const {
        return p.t > 0.0f ? glm::mix(strength(p.i), strength(p.i + 1), p.t) : strength(p.i);
    }

   private:
    const CurveChains& chains_;
    Index chain_, first_, points_;
    bool closed_;
};

/// In a closed chain, the first point that satisfies is_one(point), or the number of segments if there is none. In an
/// open chain 0.
template <typename IsOne>
Index first_of(const Walk& walk, const IsOne& is_one) {
    Index first = 0;
    while (walk.closed() && first < walk.segments() && !is_one(first)) ++first;
    return first;
}

Stretch all_of(const Walk& walk) { return {walk.chain(), {0, 0.0f}, {walk.segments(), 0.0f}, walk.closed()}; }

/// Appends the intervals above the level. `low(i)`: point i is below it. `crossing(i)`: where segment i crosses it.
template <typename Low, typename Crossing>
void cut(const Walk& walk, const Low& low, const Crossing& crossing, Array<Stretch>& out) {
    const Index segments = walk.segments(), start = first_of(walk, low);
    if (start == segments) return out.push_back(all_of(walk));
    bool open = !low(start);
    Place begin{start, 0.0f};
    for (Index i = start; i < start + segments; ++i) {
        const bool next = !low(i + 1);
        if (next == open) continue;
        if (open) out.push_back({walk.chain(), begin, crossing(i), false});
        begin = crossing(i);
        open = next;
    }
    if (open) out.push_back({walk.chain(), begin, {start + segments, 0.0f}, false});
}

/// Appends the runs of whole segments that satisfy kept(segment).
template <typename Kept>
void cut_whole(const Walk& walk, const Kept& kept, Array<Stretch>& out) {
    const Index segments = walk.segments(), start = first_of(walk, [&](Index i) { return !kept(i); });
    if (start == segments) return out.push_back(all_of(walk));
    for (Index i = start; i < start + segments;) {
        Index j = i;
        while (j < start + segments && kept(j)) ++j;
        if (j > i) out.push_back({walk.chain(), {i, 0.0f}, {j, 0.0f}, false});
        i = j + 1;
    }
}

/// Per point: whether it is in a gap below selection.level that is deeper than selection.depth.
std::vector<std::uint8_t> gaps(const Walk& walk, const Selection& selection) {
    const Index count = walk.points(), cyclic = walk.closed() ? walk.segments() : count;
    std::vector<std::uint8_t> low(count, 0);
    const auto below = [&](Index i) { return walk.strength(i) < selection.level; };
    const Index start = first_of(walk, [&](Index i) { return !below(i); }) % cyclic;
    for (Index i = start; i < start + cyclic;) {
        Index j = i;
        float least = selection.level;
        for (; j < start + cyclic && below(j); ++j) least = std::min(least, walk.strength(j));
        if (j > i && least < selection.level - selection.depth)
            for (Index k = i; k < j; ++k) low[k % cyclic] = 1;
        i = j + 1;
    }
    if (walk.closed()) low[count - 1] = low[0];
    return low;
}

bool is_strong(const Walk& walk, const Stretch& stretch, const Selection& selection) {
    float most = 0.0f;
    double sum = 0.0;
    Place from = stretch.begin;
    for (Index n = 1; n < stretch.points(); ++n) {
        const bool last = n + 1 == stretch.points();
        const Place to = last ? stretch.end : Place{stretch.begin.i + n, 0.0f};
        const float a = walk.strength(from), b = walk.strength(to);
        most = std::max({most, a, b});
        sum += 0.5 * (a + b) * glm::distance(walk.point(from), walk.point(to));
        from = to;
    }
    return most >= selection.reach && sum >= selection.least * selection.reach;
}

/// Number of points of the spur at one end of an open chain: at its start (way 1) or its end (way -1). `side`: mean
/// side length there.
Index spur(const Walk& walk, int way, float side) {
    constexpr float least_cosine = 0.5f, longest = 2.0f, before = 1.5f;
    const Index count = walk.points();
    const auto at = [&](Index n) { return walk.point({way > 0 ? n : count - 1 - n, 0.0f}); };
    const vec3 tip = at(0);
    Index found = 0, inner = 0;
    float arc = 0.0f, inner_arc = 0.0f;
    for (Index n = 1; n + 1 < count; ++n) {
        arc += glm::distance(at(n - 1), at(n));
        if (arc > longest * side) break;
        for (; inner + 1 < count && inner_arc < arc + before * side; ++inner)
            inner_arc += glm::distance(at(inner), at(inner + 1));
        const vec3 onward = at(n) - at(inner), rest = tip - at(n);
        if (glm::dot(onward, rest) < least_cosine * glm::length(onward) * glm::length(rest)) found = n;
    }
    return found;
}

/// FreeEnds of an interval of a chain, of which those that cut the chain are in `at_cuts`.
int free_ends(const CurveChains& chains, const Stretch& stretch, int at_cuts) {
    if (stretch.closed) return 0;
    const bool closed = chains.closed[stretch.chain];
    const bool from_start = !closed && stretch.begin.i == 0 && stretch.begin.t == 0.0f;
    const bool to_end = !closed && stretch.end.i + 1 == chains.rows.size(stretch.chain);
    const int before = chains.free[stretch.chain];
    return ((from_start ? before : at_cuts) & free_start) | ((to_end ? before : at_cuts) & free_end);
}

/// Builds chains from intervals of `chains`. `uniform`: with strength 1. `at_cuts`: FreeEnds where chains are cut.
CurveChains gather(const CurveChains& chains, In<Stretch> stretches, bool uniform, int at_cuts = any_free) {
    CurveChains out;
    Index points = 0;
    for (const Stretch& stretch : stretches) out.rows.offsets.push_back(points += stretch.points());
    resize_columns(out, CurveChains::curve_columns, stretches.size());
    resize_columns(out, CurveChains::point_columns, points);
    parallel_for(stretches.size(), 64, [&](std::size_t s) {
        const Stretch& stretch = stretches[s];
        const Walk walk(chains, stretch.chain);
        Index lowest = none;
        for (Index n = 0, o = out.rows.offsets[s]; n < stretch.points(); ++n, ++o) {
            const bool last = n + 1 == stretch.points();
            const Place place = n == 0 ? stretch.begin : last ? stretch.end : Place{stretch.begin.i + n, 0.0f};
            const Index here = walk.at(place.i);
            out.point[o] = walk.point(place);
            out.strength[o] = uniform ? 1.0f : walk.strength(place);
            // The segment that starts at the last point is not part of the interval.
            out.triangle[o] = last && n > 0 ? out.triangle[o - 1] : chains.triangle[here];
            out.other[o] = last && n > 0 ? out.other[o - 1] : chains.other[here];
            out.side[o] = place.t > 0.0f ? none : chains.side[here];
            lowest = std::min(lowest, out.triangle[o]);
        }
        out.closed[s] = stretch.closed;
        out.free[s] = std::uint8_t(free_ends(chains, stretch, at_cuts));
        out.anchor[s] = chains.anchor[stretch.chain] >> 32 << 32 | lowest;
    });
    return out;
}

/// Calls find(walk, out) for all chains, in parallel, and joins the results in order.
template <typename Find>
Array<Stretch> find_stretches(const CurveChains& chains, const Find& find) {
    return parallel_collect<Stretch>(chains.rows.count(), 64, [&](std::size_t begin, std::size_t end, auto& out) {
        for (std::size_t c = begin; c < end; ++c) find(Walk(chains, static_cast<Index>(c)), out);
    });
}

}  // namespace

CurveChains select_stretches(const CurveChains& chains, const Selection& selection) {
    const auto find = [&](const Walk& walk, Array<Stretch>& out) {
        Array<Stretch> stretches;
        if (selection.whole) {
            cut_whole(walk, [&](Index i) { return walk.strength(i) >= selection.level; }, stretches);
        } else {
            const auto low = gaps(walk, selection);
            const auto crossing = [&](Index i) {
                const float a = walk.strength(i), b = walk.strength(i + 1), t = (selection.level - a) / (b - a);
                return Place{i, t > 0.0f && t < 1.0f ? t : 0.5f};
            };
            const auto is_low = [&](Index i) { return low[i < walk.points() ? i : i % walk.segments()] != 0; };
            cut(walk, is_low, crossing, stretches);
        }
        for (const Stretch& stretch : stretches)
            if (is_strong(walk, stretch, selection)) out.push_back(stretch);
    };
    return gather(chains, find_stretches(chains, find), selection.uniform);
}

CurveChains without_spurs(const CurveChains& chains, const Surface& surface) {
    const auto sides = triangle_sides(surface);
    const auto side_at = [&](Index point) {
        const glm::uvec3& of = sides->of_triangle[chains.triangle[point]];
        float sum = 0.0f;
        for (int i = 0; i < 3; ++i) {
            const Edge e = sides->vertices[of[i]];
            sum += glm::distance(surface.positions[e.x], surface.positions[e.y]);
        }
        return sum / 3.0f;
    };
    const auto find = [&](const Walk& walk, Array<Stretch>& out) {
        Index begin = 0, end = walk.segments();
        if (!walk.closed()) {
            begin = spur(walk, 1, side_at(walk.at(begin)));
            end -= spur(walk, -1, side_at(walk.at(end)));
        }
        if (begin < end) out.push_back({walk.chain(), {begin, 0.0f}, {end, 0.0f}, walk.closed()});
    };
    return gather(chains, find_stretches(chains, find), false);
}

CurveChains without_triangles(const CurveChains& chains, In<std::uint8_t> removed, bool another_goes_on) {
    const auto find = [&](const Walk& walk, Array<Stretch>& out) {
        cut_whole(walk, [&](Index i) { return !removed[chains.triangle[walk.at(i)]]; }, out);
    };
    return gather(chains, find_stretches(chains, find), false, another_goes_on ? 0 : any_free);
}

}  // namespace fovea::path
