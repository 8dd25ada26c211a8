// SPDX-License-Identifier: GPL-3.0-or-later
// A style: the paper, the layers under the lines, and an ordered list of line sets with their pens. Lengths are in
// reference pixels (image height / 1080) where nothing else is said, colors scene-linear.
#pragma once

#include <fovea/style/focus.h>
#include <fovea/style/ground.h>
#include <fovea/style/json_value.h>
#include <fovea/style/line_set.h>
#include <fovea/style/thinning.h>

namespace fovea::style {

/// A pen, and the one that it becomes out of focus.
struct PenPair {
    const Pen* pen;
    const Pen* away;  ///< null: it stays as it is
};

/// A value of a style's file that is not known here.
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
    std::vector<Unknown> kept;  ///< what its file says that is not known here

    bool operator==(const Style&) const = default;

    static constexpr std::tuple fields{
        Field{"paper", &Style::paper},       Field{"line_sets", &Style::line_sets},
        Field{"focus", &Style::focus},       Field{"effects", &Style::effects},
        Field{"distance", &Style::distance}, Field{"color", &Style::color},
        Field{"elision", &Style::elision},   Field{"kept", &Style::kept, "", "", {}, "", nullptr}};

    /// Whether there is a color layer.
    bool has_color() const { return color.shading != Shading::plain && effects.colors != Mode::none; }
    /// Those of visible parts by line set, then those of hidden parts. Borrowed.
    std::vector<PenPair> pen_pairs() const;
    /// Whether lines out of focus are other than those in focus.
    bool has_away() const;
    /// How many surfaces that hide a line must be told apart; 0: hidden lines are not drawn.
    Index counted() const;
    /// Width of a pen in pixels of an image, `reference_scale` of which are a reference pixel.
    double width_px(const Pen& pen, double reference_scale) const;
};

}  // namespace fovea::style
