// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of black and white alone, as comics are printed: lines by a threshold, tones as dots of a screen.
#pragma once

#include <fovea/base/columns.h>
#include <fovea/style/field.h>

namespace fovea::color {

struct Screen {
    double dpi = 600.0;
    double lines_per_inch = 60.0;
    double angle = 45.0;
    double threshold = 0.5;

    bool operator==(const Screen&) const = default;

    static constexpr auto fields = each_of(
        style::Field{"dpi", &Screen::dpi, "Resolution", "Pixels per inch of the page, which is as high as the paper is",
                     style::number(50.0, 2400.0, 1200.0)},
        style::Field{"lines_per_inch", &Screen::lines_per_inch, "Screen", "Rows of dots per inch",
                     style::number(5.0, 200.0, 100.0)},
        style::Field{"angle", &Screen::angle, "Screen Angle", "Of the rows of dots",
                     style::Domain{0.0, 90.0, 90.0, style::Unit::degrees}},
        style::Field{"threshold", &Screen::threshold, "Threshold",
                     "Opacity from which a line is drawn: black, or white where it is light", style::share});
};

/// Height in pixels of a page of so many millimeters.
int page_height(const Screen& screen, double height_mm);

/// Whether each pixel is white: width pixels in a row, bottom row first. `lines`: premultiplied; `ground`: what lies
/// below, opaque or over white; `paper`: its color, which is white; all scene-linear. Of a gray as displayed,
/// dots of the screen cover the share that it lacks to the white of the paper. Throws std::invalid_argument for a
/// screen out of its ranges, or with dots smaller than two pixels.
Array<std::uint8_t> screentone(In<vec4> lines, In<vec4> ground, const dvec3& paper, int width, const Screen& screen);

}  // namespace fovea::color
