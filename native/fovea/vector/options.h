// SPDX-License-Identifier: GPL-3.0-or-later
// What a drawing is to be like as vectors.
#pragma once

#include <fovea/style/field.h>
#include <fovea/vector/titles.h>

namespace fovea::vector {

/// Sizes of paper.
enum class Sheet : std::uint8_t { page, pixels, a0, a1, a2, a3, a4, a5, letter };

/// What becomes of colors below the lines.
enum class Colors : std::uint8_t { picture, areas };

/// What becomes of strokes whose width changes.
enum class Widths : std::uint8_t { outline, center };

struct Options {
    Sheet sheet = Sheet::page;
    double margin = 10.0;
    bool to_scale = false;
    double tolerance = 0.02;
    Widths widths = Widths::outline;
    bool dashes_apart = false;
    bool ground = true;
    Colors colors = Colors::picture;
    bool plotter = false;
    bool title_block = false;
    Titles titles = {};
    double unit_meters = 1.0;

    bool operator==(const Options&) const = default;

    static constexpr double least_tolerance = 0.002;  ///< [mm]; less is none: files have micrometers
    static constexpr style::Domain length{0.0, 1000.0, 100.0, style::Unit::millimeters};
    static constexpr style::Domain deviation{0.0, 10.0, 1.0, style::Unit::millimeters};
    static constexpr style::Domain unit = style::number(1e-12, 1e12, 1000.0);
    static constexpr auto fields = each_of(
        style::Field{"sheet", &Options::sheet, "Paper", "Size of the paper, which lies as the picture does"},
        style::Field{"margin", &Options::margin, "Margin", "Left free around the picture on a sheet of paper", length},
        style::Field{"to_scale", &Options::to_scale, "To Scale",
                     "On a sheet of paper, too, the picture is as large as the style's paper says"},
        style::Field{"tolerance", &Options::tolerance, "Tolerance",
                     "How far curves may lie beside the lines that they stand for; below 0.002: no curves", deviation},
        style::Field{"widths", &Options::widths, "Changing Widths", "What becomes of strokes whose width changes"},
        style::Field{"dashes_apart", &Options::dashes_apart, "Dashes Apart", "Each dash is a line of its own"},
        style::Field{"ground", &Options::ground, "Paper and Colors",
                     "The color of the paper, and colors below the lines"},
        style::Field{"colors", &Options::colors, "Colors As", "What becomes of the colors below the lines"},
        style::Field{"plotter", &Options::plotter, "For a Plotter",
                     "Lines of one width in an order of short ways, joined where they meet, each once"},
        style::Field{
            "title_block", &Options::title_block, "Title Block",
            "A frame and a title block (ISO 7200) on a sheet of paper: the picture is above the block or beside it"},
        style::Field{"titles", &Options::titles, "Titles", "What the title block says"},
        style::Field{"unit_meters", &Options::unit_meters, "Unit",
                     "Meters to a unit of the scene, for the scale in the title block", unit});
};

}  // namespace fovea::vector

namespace fovea::style {
template <>
inline constexpr Choice choices_of<vector::Sheet>[] = {
    {"page", "Page", "As high as the style's paper says, and as wide as the picture is"},
    {"pixels", "Pixels", "A unit for each pixel of the picture: for the web"},
    {"a0", "A0", "841 x 1189 mm"},
    {"a1", "A1", "594 x 841 mm"},
    {"a2", "A2", "420 x 594 mm"},
    {"a3", "A3", "297 x 420 mm"},
    {"a4", "A4", "210 x 297 mm"},
    {"a5", "A5", "148 x 210 mm"},
    {"letter", "Letter", "8.5 x 11 inches"},
};

template <>
inline constexpr Choice choices_of<vector::Colors>[] = {
    {"picture", "Picture", "They are one picture"},
    {"areas", "Areas", "Each object, material and band of toon shading is a filled area of one color"},
};

template <>
inline constexpr Choice choices_of<vector::Widths>[] = {
    {"outline", "Outlines", "They are outlines that are filled"},
    {"center", "Center Lines", "They are lines of their mean width, which are easily edited"},
};
}  // namespace fovea::style
