// SPDX-License-Identifier: GPL-3.0-or-later
// A frame as a document: a layer for each line set, in it one for visible parts of lines and one for hidden ones.
#pragma once

#include <fovea/draw/frame.h>
#include <fovea/vector/document.h>
#include <fovea/vector/options.h>

namespace fovea::vector {

/// How much there is in a drawing.
struct Figures {
    std::size_t strokes = 0;
    std::size_t paths = 0;
    std::size_t numbers = 0;
    std::size_t polyline_numbers = 0;

    static constexpr auto fields = each_of(
        style::Field{"strokes", &Figures::strokes, "", "Runs of lines of which anything is drawn"},
        style::Field{"paths", &Figures::paths, "", "Of the document: strokes and parts of them"},
        style::Field{"numbers", &Figures::numbers, "", "Coordinates of the paths' curves"},
        style::Field{"polyline_numbers", &Figures::polyline_numbers, "", "Coordinates of the runs as they are found"});
};

/// The way of a plotter's pen.
struct Way {
    double pen_down_mm = 0.0;
    double pen_up_mm = 0.0;
    double pen_up_nearest_mm = 0.0;
    double pen_up_unordered_mm = 0.0;
    std::size_t lifts = 0;

    static constexpr auto fields = each_of(
        style::Field{"pen_down_mm", &Way::pen_down_mm, "", "Length of what the pen draws"},
        style::Field{"pen_up_mm", &Way::pen_up_mm, "", "And of its ways between that"},
        style::Field{"pen_up_nearest_mm", &Way::pen_up_nearest_mm, "", "The same, always to the nearest end"},
        style::Field{"pen_up_unordered_mm", &Way::pen_up_unordered_mm, "", "The same, in the order of the scene"},
        style::Field{"lifts", &Way::lifts, "", "How often it is lifted"});
};

struct Drawing {
    Document document;
    Figures figures;
    std::optional<Way> way;  ///< of a plotter

    /// Calls visit(name, number) for each figure.
    template <typename Visit>
    void for_each_figure(const Visit& visit) const {
        style::for_each_field<Figures>([&](const auto& field) { visit(field.name, figures.*field.member); });
        if (way) style::for_each_field<Way>([&](const auto& field) { visit(field.name, *way.*field.member); });
    }
};

/// The strokes of a frame as it draws them, after haloes, overshoot and elision. Takes the frame's steps up to shape(),
/// and with a ground that is more than a color all of them. Throws std::invalid_argument for options out of their
/// range.
Drawing compose(Frame& frame, const Options& asked);

}  // namespace fovea::vector
