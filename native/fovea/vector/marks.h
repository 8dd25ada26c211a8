// SPDX-License-Identifier: GPL-3.0-or-later
// The strokes of a frame on a page: polylines with widths, each of one color and opacity.
#pragma once

#include <fovea/draw/frame.h>
#include <fovea/vector/curve.h>
#include <fovea/vector/grain.h>
#include <fovea/vector/page.h>

namespace fovea::vector {

/// A stroke, or a part of it along which its color and opacity are about the same.
struct Mark {
    Index run = none;                 ///< of the frame's drawn runs
    Points points = {};               ///< in units of the page
    std::vector<double> widths = {};  ///< per point; of pens in millimeters true on every page
    std::vector<dvec2> anchors = {};  ///< per point, of dashes fixed to the path: CenterPoint's along, whole_px
    double arc = 0.0;                 ///< along its path to its first point, 0 at the path's middle
    dvec3 color{0.0};                 ///< as displayed
    double opacity = 1.0;
    bool closed = false;              ///< the last point repeats the first
    bool is_dash = false;             ///< of a stroke that has dashes
    bool starts = true, ends = true;  ///< whether its ends have caps: those of the stroke and of the picture
};

struct Marks {
    std::vector<Mark> marks;    ///< by run, then along it
    std::vector<Grain> grains;  ///< per pen
    std::size_t numbers = 0;    ///< of the coordinates of the drawn runs as polylines
};

/// How strokes are cut into marks.
enum class Cutting : std::uint8_t {
    by_ink,   ///< where their color or opacity changes
    unseen,   ///< where nothing is drawn alone: they have their mean color and opacity
    elision,  ///< where elision leaves less than half: what is left is fully drawn, and ends in the picture
};

/// Requires shape(). Where nothing is drawn, as elision or a transparent pen has it, there are no marks; they end where
/// no ink of theirs is in the picture any more. `tolerance`: of curves that are made of them.
Marks marks_of(const Frame& frame, const Page& page, double tolerance, Cutting cutting);

/// Mean of the widths of a mark, by length.
double mean_width(const Mark& mark);

}  // namespace fovea::vector
