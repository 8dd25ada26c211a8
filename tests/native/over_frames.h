// SPDX-License-Identifier: GPL-3.0-or-later
// Frames that answer to those near them, and what visibility over frames makes of a bar that passes.
#pragma once

#include <memory>
#include <string>

#include <fovea/draw/frame.h>
#include <fovea/focus/at_samples.h>
#include <fovea/style/json.h>

#include "drawing.h"

namespace fovea::over_frames {
using namespace drawing;

inline constexpr double across = 4.0;  // units from the left to the right of the picture
inline constexpr int width = 400, height = 300;

/// Lines of one definition in strokes of 6 pixels, over so many frames to each side.
inline style::Style style_of(const std::string& definition, int frames, style::Vanish vanish = style::Vanish::fade,
                             bool elided = false) {
    style::Style style = style::read_style(R"({"schema": 1, "line_sets": [{"kinds": {")" + definition +
                                           R"(": {}}, "least_length": 0,
        "pen": {"width": 6, "width_unit": "pixels", "cap": "butt"}}]})");
    style.animation.visibility_frames = frames;
    style.animation.vanish = vanish;
    style.elision.enabled = elided;
    return style;
}

/// A picture of placements, from `eye` towards the origin.
inline Job job_of(std::vector<Placement> placements, dvec3 eye, const style::Style& style) {
    return {.scene = std::make_shared<Scene>(Scene(std::move(placements))),
            .view = orthographic(eye, {0, 0, 0}, across, width, height),
            .style = style,
            .assets = std::make_shared<Assets>("."),
            .backend = std::make_shared<CpuBackend>()};
}

/// Frame 0 of those that job(frame) makes, over so many frames to each side.
template <typename Make>
std::unique_ptr<Frame> middle_of(int frames, const Make& job) {
    Job middle = job(0);
    for (int k = -frames; k <= frames; ++k)
        if (k != 0) middle.near.emplace_back(k, Frame(job(k)).found_lines()->lines);
    auto frame = std::make_unique<Frame>(std::move(middle));
    frame->picture();
    return frame;
}

/// Place of a pixel in units from the middle of the picture, to the right and up.
inline dvec2 units_of(const vec2& px) {
    return (dvec2(px) / double(width) - 0.5 * dvec2(1.0, double(height) / width)) * across;
}

/// Calls visit(place, sample) for the samples of the lines, in units_of.
template <typename Visit>
void each_sample(const Frame& frame, const Visit& visit) {
    const Array<vec2> places =
        at_samples(*frame.clipped, [&](const SamplePlace& at) { return px_at(*frame.clipped, at); });
    for (std::size_t s = 0; s < places.size(); ++s) visit(units_of(places[s]), Index(s));
}

/// Share of the time from -frames to frames for which a bar that passes 0 at time 0 does not hide a place.
inline double trapezoid(double x, double bar_width, double speed, int frames) {
    const double from = std::max((x - 0.5 * bar_width) / speed, -double(frames));
    const double to = std::min((x + 0.5 * bar_width) / speed, double(frames));
    return 1.0 - std::max(to - from, 0.0) / (2.0 * frames);
}

}  // namespace fovea::over_frames
