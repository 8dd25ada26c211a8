// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>

#include <fovea/cutout/clip.h>

namespace fovea::cutout {
namespace {

double turn_at(const dvec2& a, const dvec2& b, const dvec2& c) { return cross(b - a, c - a); }

/// Whether the segments from a to b and from c to d cross, or touch elsewhere than at a common end.
bool collide(const dvec2& a, const dvec2& b, const dvec2& c, const dvec2& d) {
    const bool common = a == c || a == d || b == c || b == d;
    const double abc = turn_at(a, b, c), abd = turn_at(a, b, d), cda = turn_at(c, d, a), cdb = turn_at(c, d, b);
    if (common) return false;
    return abc * abd <= 0.0 && cda * cdb <= 0.0;
}

bool collides(const dvec2& a, const dvec2& b, const std::vector<PieceCorner>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (collide(a, b, loop[i].place, loop[(i + 1) % loop.size()].place)) return true;
    return false;
}

/// Whether a seam from corner i of a counterclockwise polygon to `to` starts on its inside.
bool starts_inside(const std::vector<PieceCorner>& polygon, std::size_t i, const dvec2& to) {
    const dvec2& at = polygon[i].place;
    const dvec2& before = polygon[(i + polygon.size() - 1) % polygon.size()].place;
    const dvec2& after = polygon[(i + 1) % polygon.size()].place;
    const bool left_of_last = turn_at(before, at, to) > 0.0, left_of_next = turn_at(at, after, to) > 0.0;
    return turn_at(before, at, after) > 0.0 ? left_of_last && left_of_next : left_of_last || left_of_next;
}

}  // namespace

void join_hole(std::vector<PieceCorner>& around, const std::vector<PieceCorner>& hole, const Pieces& others) {
    const auto right = std::max_element(hole.begin(), hole.end(), [](const PieceCorner& a, const PieceCorner& b) {
        return std::pair(a.place.x, a.place.y) < std::pair(b.place.x, b.place.y);
    });
    const dvec2 from = right->place;
    const auto free = [&](std::size_t i) {
        const dvec2& to = around[i].place;
        return starts_inside(around, i, from) && !collides(from, to, around) && !collides(from, to, hole) &&
               std::none_of(others.begin(), others.end(), [&](const auto& other) { return collides(from, to, other); });
    };
    // The nearest corners first, in a heap: of thousands only a few are looked at.
    using Away = std::pair<double, std::size_t>;
    std::vector<Away> near(around.size());
    for (std::size_t i = 0; i < near.size(); ++i) near[i] = {glm::distance(around[i].place, from), i};
    std::ranges::make_heap(near, std::greater());
    while (!near.empty() && !free(near.front().second)) {
        std::ranges::pop_heap(near, std::greater());
        near.pop_back();
    }
    if (near.empty()) return;  // touching outlines leave no way: the hole is filled
    const std::size_t found = near.front().second;
    std::vector<PieceCorner> seam(right, hole.end());
    seam.insert(seam.end(), hole.begin(), right);
    seam.push_back(*right);
    seam.push_back(around[found]);
    around.insert(around.begin() + std::ptrdiff_t(found) + 1, seam.begin(), seam.end());
}

}  // namespace fovea::cutout
