// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of lines of the view, handed on from frame to frame.
#include <gtest/gtest.h>

#include <fovea/stroke/marks.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

constexpr double period = 18.0;

std::shared_ptr<const ViewLines> lines_of(const char* name, double degrees) {
    const double a = glm::radians(degrees);
    const View view = perspective({8 * std::sin(a), -8 * std::cos(a), 1.5}, {0, 0, 0}, 80);
    const auto bumps = meshes::relief(120, [](double x, double y) { return 0.3 * std::sin(4 * x + 1) * std::cos(3 * y); });
    const Drawing drawing({place(bumps, dmat4(1.0), 7)}, view, {line_set(std::vector<const char*>{name})});
    return std::make_shared<ViewLines>(
        view_lines(drawing.clipped, drawing.paths, drawing.scene, view, std::vector<double>{period}));
}

}  // namespace

TEST(Marks, Debug) {
    for (const char* name : {"contour", "smooth_contour", "suggestive_contour"}) {
        std::vector<std::shared_ptr<const ViewLines>> all;
        for (int k = 0; k < 8; ++k) all.push_back(lines_of(name, 10 + 0.25 * k));
        std::vector<Marks> marks;
        for (int k = 0; k < 8; ++k) {
            std::vector<ViewNear> near;
            for (int i = 0; i < 8; ++i)
                if (i != k) near.emplace_back(i - k, all[i]);
            marks.push_back(marks_in_time(all[k], near, k, 64));
        }
        for (int k = 1; k < 8; ++k) {
            const ViewLines &a = *all[k - 1], &b = *all[k];
            std::vector<double> slide, own;
            for (std::size_t j = 0; j < b.places.size(); ++j) {
                const auto& place = b.places[j];
                const dvec4 clip = a.view.view_to_clip * (a.placed[0].object_to_view * dvec4(place.position, 1.0));
                const dvec2 px = to_pixels(a.view, clip);
                double best = 6;
                std::size_t at = none;
                for (std::size_t i = 0; i < a.places.size(); ++i)
                    if (glm::distance(a.places[i].px, px) < best && std::abs(glm::dot(a.places[i].way, place.way)) > 0.7) best = glm::distance(a.places[i].px, px), at = i;
                if (at == none) continue;
                const double s = glm::dot(px - a.places[at].px, a.places[at].way);
                const std::size_t e = at + 1 < a.rows.end(a.places[at].piece) ? at + 1 : at - 1;
                const double slope = (marks[k-1].at[e] - marks[k-1].at[at]) / (a.places[e].arc - a.places[at].arc);
                const double slope0 = (a.places[e].own - a.places[at].own) / (a.places[e].arc - a.places[at].arc);
                double d = marks[k].at[j] - marks[k - 1].at[at] - slope * s;
                double d0 = place.own - a.places[at].own - slope0 * s;
                slide.push_back(std::abs(d - period * std::round(d / period)));
                own.push_back(std::abs(d0 - period * std::round(d0 / period)));
            }
            std::sort(slide.begin(), slide.end());
            std::sort(own.begin(), own.end());
            if (slide.empty()) { printf("%s none of %zu\n", name, b.places.size()); continue; }
            printf("%s %d places %zu pieces %u matched %zu slide %.3f %.3f own %.3f %.3f\n", name, k, b.places.size(), b.rows.count(), slide.size(),
                   slide[slide.size() / 2], slide[slide.size() * 95 / 100], own[own.size() / 2], own[own.size() * 95 / 100]);
        }
    }
}
