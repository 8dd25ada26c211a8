// SPDX-License-Identifier: GPL-3.0-or-later
// Section hatch: parallel lines on the inside of what the section plane cuts.
// In   the sides of the section in the image (scene/section.h)
// Out  lines at an angle and a spacing on paper, clipped to the inside; placed relative to the image of the view axis,
//      so that parts of a picture have the same ones
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <mutex>

#include <fovea/image/spans.h>
#include <fovea/line/definition.h>
#include <fovea/scene/section.h>

namespace fovea::line {
namespace {

struct SectionHatch {
    double angle, spacing;
};

const Parameters<SectionHatch> section_hatch_parameters{{&SectionHatch::angle, "angle", "Angle", 45.0, -90.0, 90.0,
                                                         Unit::degrees, "Direction of the lines, from the horizontal"},
                                                        {&SectionHatch::spacing, "spacing", "Spacing", 2.0, 0.1, 100.0,
                                                         Unit::millimeters, "Distance between the lines, on paper"}};

/// Narrowest spacing of lines [px]: closer ones are a tone.
constexpr double least_px = 0.5;

/// View-space point of the plane under a pixel position.
class OnPlane {
   public:
    OnPlane(const View& view, const dvec4& plane)
        : view_(view), clip_to_view_(glm::inverse(view.view_to_clip)), plane_(plane) {}

    dvec3 at(const dvec2& px) const {
        const dvec3 near = on_near_plane(view_, clip_to_view_, px), normal(plane_);
        if (!view_.orthographic) return near * (-plane_.w / glm::dot(normal, near));
        return {near.x, near.y, -(plane_.w + normal.x * near.x + normal.y * near.y) / normal.z};
    }

   private:
    const View& view_;
    dmat4 clip_to_view_;
    dvec4 plane_;
};

Curves find_section_hatch(const FrameView& frame, const SectionHatch& values) {
    const View& view = frame.tracer.view();
    const Scene& scene = frame.tracer.scene();
    const Array<SectionSide> outline = section_sides(scene, view);
    const std::optional<dvec4> section = section_in_view(scene, view);
    if (outline.empty() || !section) return {};
    const double angle = glm::radians(values.angle), step = std::max(values.spacing * view.reference_scale, least_px);
    const dvec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    const dvec2 axis = to_pixels(view, view.view_to_clip * dvec4(0, 0, -1, 1));
    const auto turned = [&](const dvec2& px) { return dvec2(glm::dot(px - axis, along), glm::dot(px - axis, across)); };
    const auto sides = parallel_map<image::Side>(
        outline.size(), [&](std::size_t i) { return image::Side{turned(outline[i].from), turned(outline[i].to)}; });
    // Lines that meet the frame.
    const double reach =
        glm::length(dvec2(view.width, view.height)) + glm::length(axis - 0.5 * dvec2(view.width, view.height));
    const int half = int(std::ceil(reach / step));
    const OnPlane plane(view, *section);
    Curves pieces;
    std::mutex mutex;
    image::each_span(sides, {-half * step, step, 2 * half + 1}, [&](int line, double begin, double end) {
        begin = std::max(begin, -reach);
        end = std::min(end, reach);
        if (!(begin < end)) return;
        const auto point = [&](double x) { return vec3(plane.at(axis + x * along + (line - half) * step * across)); };
        const CurvePiece piece{.triangle = 0,
                               .side = {none, none},
                               .point = {point(begin), point(end)},
                               .strength = {1.0f, 1.0f},
                               .level = Index(line)};
        const std::lock_guard lock(mutex);
        pieces.push_back(piece);
    });
    // By line, and along each: numbered so that no two have the same id.
    const dvec3 way(along, 0.0);
    std::sort(pieces.begin(), pieces.end(), [&](const CurvePiece& a, const CurvePiece& b) {
        return a.level != b.level ? a.level < b.level
                                  : glm::dot(way, dvec3(a.point[0])) < glm::dot(way, dvec3(b.point[0]));
    });
    for (std::size_t i = 1; i < pieces.size(); ++i)
        if (pieces[i].level == pieces[i - 1].level) pieces[i].triangle = pieces[i - 1].triangle + 1;
    return pieces;
}

}  // namespace

extern const LineDefinition section_hatch = {
    .name = "section_hatch",
    .label = "Section Hatch",
    .source = "Common knowledge",
    .description = "Parallel lines on the inside of what the section plane cuts",
    .scope = Scope::scene,
    .importance = 0.05,
    .parameters = section_hatch_parameters,
    .rule = ImageRule{section_hatch_parameters.of(find_section_hatch)},
    .ends_at_lines = true,
    .usual = true,
};

}  // namespace fovea::line
