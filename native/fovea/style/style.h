// SPDX-License-Identifier: GPL-3.0-or-later
// A style: the paper, the layers under the lines, and an ordered list of line sets with their pens. Lengths are in
// reference pixels (image height / 1080) unless stated otherwise, colors scene-linear.
#pragma once

#include <fovea/style/animation.h>
#include <fovea/style/focus.h>
#include <fovea/style/ground.h>
#include <fovea/style/json_value.h>
#include <fovea/style/line_set.h>
#include <fovea/style/thinning.h>

namespace fovea::style {

/// A pen and its counterpart out of focus.
struct PenPair {
    const Pen* pen;
    const Pen* away;  ///< null: `pen` everywhere
};

/// A value of a style file that this version does not know.
struct Unknown {
    Path path;
    std::string json;

    bool operator==(const Unknown&) const = default;
};

struct Style {
    Paper paper;
    std::vector<LineSet> line_sets{LineSet()};
    Focus focus;
    Effects effects;
    Distance distance;
    Color color;
    Elision elision;
    Section section;
    Animation animation;
    std::vector<Unknown> kept;  ///< unknown values of its file, written back unchanged

    bool operator==(const Style&) const = default;

    static constexpr auto fields =
        each_of(Field{"paper", &Style::paper}, Field{"line_sets", &Style::line_sets}, Field{"focus", &Style::focus},
                Field{"effects", &Style::effects}, Field{"distance", &Style::distance}, Field{"color", &Style::color},
                Field{"elision", &Style::elision}, Field{"section", &Style::section},
                Field{"animation", &Style::animation}, Field{"kept", &Style::kept, "", "", {}, "", nullptr});

    /// Whether there is a color layer.
    bool has_color() const { return color.shading != Shading::plain && effects.colors != Mode::none; }
    /// Pens of visible parts by line set, then those of hidden parts; pointers into this style.
    std::vector<PenPair> pen_pairs() const;
    /// Whether any pen or overshoot differs out of focus.
    bool has_away() const;
    /// Whether a pen fixes its marks to paths.
    bool fixes_marks() const;
    /// Levels of quantitative invisibility that the ranges distinguish; 0: hidden lines are not drawn.
    Index counted() const;
    /// Width of a pen in image pixels. `reference_scale`: image pixels per reference pixel.
    double width_px(const Pen& pen, double reference_scale) const;
};

}  // namespace fovea::style
