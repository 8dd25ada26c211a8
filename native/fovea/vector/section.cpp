// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/section.h>

#include <map>
#include <utility>

#include <fovea/color/srgb.h>
#include <fovea/scene/section.h>

namespace fovea::vector {
namespace {

/// What of a polygon is in a rectangle: beyond a side of it, the polygon goes along that.
Points inside(Points polygon, const dvec2& lower, const dvec2& upper) {
    for (int side = 0; side < 4; ++side) {
        const auto room = [&](const dvec2& p) {
            return side < 2 ? p[side] - lower[side] : upper[side - 2] - p[side - 2];
        };
        Points kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            if (room(a) >= 0.0) kept.push_back(a);
            if (room(a) * room(b) < 0.0) kept.push_back(glm::mix(a, b, room(a) / (room(a) - room(b))));
        }
        polygon = std::move(kept);
    }
    return polygon;
}

/// Closed curves through sides that end where another begins, as far as they are in the picture of a size in pixels.
/// What does not close is left out.
std::vector<Curve> loops_of(In<SectionSide> sides, const dvec2& picture, const Page& page) {
    std::multimap<std::pair<double, double>, Index> from;
    for (Index i = 0; i < sides.size(); ++i)
        if (sides[i].from != sides[i].to) from.emplace(std::pair(sides[i].from.x, sides[i].from.y), i);
    std::vector<Curve> loops;
    while (!from.empty()) {
        const dvec2 start = sides[from.begin()->second].from;
        Points points;
        dvec2 at = start;
        do {
            const auto next = from.find({at.x, at.y});
            if (next == from.end()) break;
            points.push_back(page.place(at));
            at = sides[next->second].to;
            from.erase(next);
        } while (at != start);
        if (at != start) continue;
        points = inside(std::move(points), page.place({0, 0}), page.place(picture));
        if (points.size() < 3) continue;
        points.push_back(points.front());
        loops.push_back(Curve::through(points, true));
    }
    return loops;
}

}  // namespace

Layer section_layer(const Frame& frame, const Page& page) {
    const style::Section& section = frame.job.style.section;
    Layer layer{"section", "section", {}, {}, {}};
    if (!section.filled) return layer;
    Path path;
    path.id = "section-fill";
    path.kind = "section";
    path.look.color = color::displayed(section.color);
    const View& view = frame.job.view;
    path.curves = loops_of(section_sides(*frame.job.scene, view), {view.width, view.height}, page);
    if (!path.curves.empty()) layer.paths.push_back(std::move(path));
    return layer;
}

}  // namespace fovea::vector
