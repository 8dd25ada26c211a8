// SPDX-License-Identifier: GPL-3.0-or-later
// Welding and orientation: what needs no surface yet.
#include <fovea/mesh/repair_polygons.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fovea/base/hash.h>

namespace fovea {
namespace {

/// The number of the vertex that stands for each: the first one within the distance that stands for itself.
std::vector<Index> representatives(const std::vector<dvec3>& positions, double distance) {
    std::unordered_map<std::uint64_t, std::vector<Index>> cells;
    const auto cell_of = [&](const dvec3& p) { return glm::floor(p / distance); };
    const auto key = [](const dvec3& cell) { return hash_bytes(&cell, sizeof cell); };
    std::vector<Index> result(positions.size());
    for (Index v = 0; v < positions.size(); ++v) {
        result[v] = v;
        const dvec3 p = positions[v];
        if (!std::isfinite(p.x + p.y + p.z)) continue;
        const dvec3 home = cell_of(p);
        for (int i = 0; i < 27; ++i) {
            // Adding zero makes -0 and 0 one cell.
            const auto found = cells.find(key(home + dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1) + 0.0));
            if (found == cells.end()) continue;
            for (Index other : found->second)
                if (glm::distance(positions[other], p) <= distance) result[v] = std::min(result[v], other);
        }
        if (result[v] == v) cells[key(home + 0.0)].push_back(v);
    }
    return result;
}

bool has_twice(std::vector<Index> vertices) {
    std::sort(vertices.begin(), vertices.end());
    return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

struct Side {
    Index low, high, polygon;
    bool forward;
};

/// Sides of polygons, those of one edge together.
std::vector<Side> sides_of(const std::vector<Polygon>& polygons) {
    std::vector<Side> sides;
    for (Index f = 0; f < polygons.size(); ++f) {
        const auto& v = polygons[f].vertices;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const Index a = v[i], b = v[(i + 1) % v.size()];
            sides.push_back({std::min(a, b), std::max(a, b), f, a < b});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.polygon) < std::tie(b.low, b.high, b.polygon);
    });
    return sides;
}

struct Neighbour {
    Index polygon;
    bool agrees;
};

void turn(Polygon& polygon) {
    std::reverse(polygon.vertices.begin(), polygon.vertices.end());
    for (Triangle& t : polygon.triangles) std::swap(t.y, t.z);
}

/// Six times the volume that a polygon spans with the origin.
double volume(const Polygons& all, const Polygon& polygon, const dvec3& origin) {
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < polygon.vertices.size(); ++i) {
        const auto at = [&](std::size_t k) { return all.positions[polygon.vertices[k]] - origin; };
        sum += glm::dot(at(0), glm::cross(at(i), at(i + 1)));
    }
    return sum;
}

}  // namespace

Index weld(Polygons& all, double distance) {
    const std::vector<Index> stands = representatives(all.positions, distance);
    std::vector<std::uint8_t> gone(stands.size(), 0);
    std::vector<Polygon> kept;
    for (Polygon& polygon : all.polygons) {
        const std::size_t before = polygon.vertices.size();
        for (Index& v : polygon.vertices) {
            gone[v] |= stands[v] != v;
            v = stands[v];
        }
        for (Triangle& t : polygon.triangles) t = {stands[t.x], stands[t.y], stands[t.z]};
        auto& v = polygon.vertices;
        v.erase(std::unique(v.begin(), v.end()), v.end());
        while (v.size() > 1 && v.front() == v.back()) v.pop_back();
        if (v.size() == before || (v.size() >= 3 && !has_twice(v) && v.size() <= 4)) {
            if (v.size() <= 4) polygon.triangles.clear();
            kept.push_back(std::move(polygon));
            continue;
        }
        // What is left of a polygon of many corners: its triangles.
        for (const Triangle& t : polygon.triangles)
            if (t.x != t.y && t.y != t.z && t.z != t.x) kept.push_back({{t.x, t.y, t.z}, polygon.origin});
    }
    all.polygons = std::move(kept);
    EdgeMarks marks;
    all.marks.each([&](Index a, Index b, std::uint8_t bits) { marks.add(stands[a], stands[b], bits); });
    all.marks = std::move(marks);
    return static_cast<Index>(std::count(gone.begin(), gone.end(), 1));
}

Index orient(Polygons& all) {
    const std::vector<Side> sides = sides_of(all.polygons);
    std::vector<std::vector<Neighbour>> around(all.polygons.size());
    std::vector<std::uint8_t> open(all.polygons.size(), 0);
    for (std::size_t begin = 0, end; begin < sides.size(); begin = end) {
        end = begin + 1;
        while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high) ++end;
        const Side &a = sides[begin], &b = sides[end - 1];
        if (end - begin == 2 && a.polygon != b.polygon) {
            around[a.polygon].push_back({b.polygon, a.forward != b.forward});
            around[b.polygon].push_back({a.polygon, a.forward != b.forward});
        } else {
            for (std::size_t i = begin; i < end; ++i) open[sides[i].polygon] = 1;
        }
    }
    Index turned = 0;
    std::vector<std::uint8_t> seen(all.polygons.size(), 0);  // 1: as it is, 2: turned
    for (Index seed = 0; seed < all.polygons.size(); ++seed) {
        if (seen[seed] || all.polygons[seed].vertices.empty()) continue;  // without corners there is no side to turn
        std::vector<Index> part{seed};
        seen[seed] = 1;
        bool closed = true;
        double sum = 0.0;
        Index other = 0;
        const dvec3 origin = all.positions[all.polygons[seed].vertices.front()];
        for (std::size_t i = 0; i < part.size(); ++i) {
            const Index f = part[i];
            closed = closed && !open[f];
            other += seen[f] == 2;
            sum += (seen[f] == 2 ? -1.0 : 1.0) * volume(all, all.polygons[f], origin);
            for (const Neighbour& next : around[f]) {
                if (seen[next.polygon]) continue;
                seen[next.polygon] = next.agrees ? seen[f] : std::uint8_t(3 - seen[f]);
                part.push_back(next.polygon);
            }
        }
        // Outwards where there is an outside; else as most of them are already.
        const bool all_over = closed ? sum < 0.0 : 2 * other > part.size();
        for (Index f : part)
            if ((seen[f] == 2) != all_over) {
                turn(all.polygons[f]);
                ++turned;
            }
    }
    return turned;
}

}  // namespace fovea
