// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/section.h>

#include <map>
#include <utility>

#include <fovea/color/srgb.h>
#include <fovea/scene/section.h>

namespace fovea::vector {
namespace {

/// Closed curves through sides that end where another begins. What does not close is left out.
std::vector<Curve> loops_of(In<SectionSide> sides, const Page& page) {
    std::multimap<std::pair<double, double>, Index> from;
    for (Index i = 0; i < sides.size(); ++i)
        if (sides[i].from != sides[i].to) from.emplace(std::pair(sides[i].from.x, sides[i].from.y), i);
    std::vector<Curve> loops;
    while (!from.empty()) {
        const dvec2 start = sides[from.begin()->second].from;
        Points points;
        for (dvec2 at = start; points.empty() || at != start;) {
            const auto next = from.find({at.x, at.y});
            if (next == from.end()) break;
            points.push_back(page.place(at));
            at = sides[next->second].to;
            from.erase(next);
            if (at == start) points.push_back(page.place(at));
        }
        if (points.size() > 3 && points.front() == points.back()) loops.push_back(Curve::through(points, true));
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
    path.curves = loops_of(section_sides(*frame.job.scene, frame.job.view), page);
    if (!path.curves.empty()) layer.paths.push_back(std::move(path));
    return layer;
}

}  // namespace fovea::vector
