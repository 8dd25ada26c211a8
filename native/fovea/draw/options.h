// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of the method that are not part of a style.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <fovea/style/field.h>

namespace fovea::draw {

/// Methods of visibility.
enum class Visibility : std::uint8_t {
    exact,       ///< rays: the same answer on every machine (visibility/exact.h)
    atlas,       ///< depth buffer probes at every sample along lines (visibility/sampled.h)
    spine,       ///< depth buffer probes at every pixel of a stroke (visibility/spine.h)
    item_buffer  ///< item buffer tested against a depth buffer (visibility/item_buffer.h)
};

/// (line set, names of its line definitions of which only the outer boundary of the object is drawn).
using Outlines = std::vector<std::pair<int, std::vector<std::string>>>;

struct Options {
    Visibility visibility = Visibility::exact;
    double sample_step = 2.0;    ///< reference pixels between visibility samples
    int depth_scale = 2;         ///< texels of the depth buffer per pixel, along each axis
    int probes = 9;              ///< depth buffer probes per sample
    int layers = 3;              ///< lines per texel of the item buffer
    double gap = 3.0;            ///< maximum gap that is closed [reference px]; more than one sample
    double spur = 1.0;           ///< maximum length of spurs that are removed [reference px]
    double contour_spur = 10.0;  ///< the same in contours, which break up at their ends on smooth surfaces
    double fold = 30.0;          ///< maximum length of folds cut off ends of contours [reference px]
    double tip = 6.0;            ///< maximum size of lines that peek out alone, and are removed [reference px]
    double dot = 3.0;            ///< maximum size of contours of bumps that are removed [reference px]
    double joint = 2.0;          ///< distance up to which a contour goes on across a fold of itself [reference px]
    double fair = 1.5;           ///< how far fairing moves contours along mesh edges at most [reference px]
    double meet = 8.0;           ///< maximum extension of a contour over its own facets, to another line [reference px]
    double beside = 4.0;         ///< distance within which a hidden line beside a visible one is removed [reference px]
    double least_hidden = 6.0;   ///< minimum length of hidden parts between visible ones [reference px]
    /// Drafts: lines of a set that are not the outer boundary go to the next set that draws them. Hidden parts have no
    /// pens then.
    Outlines outlines = {};
    bool all_paths = false;   ///< whether paths are found, too, that are too short to be drawn
    int focus_step = 1;       ///< drafts: spacing [px] at which focus is evaluated for the color layer
    bool with_depth = false;  ///< whether to make the depth pass
    bool with_focus = false;  ///< whether to make the focus pass, if the style has focus
    // Passes of line_passes.h:
    bool with_hidden = false;
    bool with_line_sets = false;
    bool with_line_depth = false;
    bool with_line_vector = false;
    bool with_line_id = false;
    int boil_drawing = 0;  ///< number of the drawing in the cycle of the style's boil
    int matte_ranks = 0;   ///< objects per pixel that a Cryptomatte tells apart; 0: none is made

    bool operator==(const Options&) const = default;

    static constexpr style::Domain length = style::number(0.0, 10000.0, 100.0);
    static constexpr style::Domain reach = style::number(0.001, 10000.0, 100.0);
    static constexpr auto fields = each_of(
        style::Field{"visibility", &Options::visibility},
        style::Field{"sample_step", &Options::sample_step, "", "", style::number(0.01, 1000.0, 100.0)},
        style::Field{"depth_scale", &Options::depth_scale, "", "", style::number(1, 8, 3)},
        style::Field{"probes", &Options::probes, "", "", style::number(1, 16, 16)},
        style::Field{"layers", &Options::layers, "", "", style::number(1, 3, 3)},
        style::Field{"gap", &Options::gap, "", "", length}, style::Field{"spur", &Options::spur, "", "", length},
        style::Field{"contour_spur", &Options::contour_spur, "", "", length},
        style::Field{"fold", &Options::fold, "", "", length}, style::Field{"tip", &Options::tip, "", "", length},
        style::Field{"dot", &Options::dot, "", "", length}, style::Field{"joint", &Options::joint, "", "", length},
        style::Field{"fair", &Options::fair, "", "", length}, style::Field{"meet", &Options::meet, "", "", reach},
        style::Field{"beside", &Options::beside, "", "", reach},
        style::Field{"least_hidden", &Options::least_hidden, "", "", length},
        style::Field{"outlines", &Options::outlines}, style::Field{"all_paths", &Options::all_paths},
        style::Field{"focus_step", &Options::focus_step, "", "", style::number(1, 1000, 8)},
        style::Field{"with_depth", &Options::with_depth}, style::Field{"with_focus", &Options::with_focus},
        style::Field{"with_hidden", &Options::with_hidden}, style::Field{"with_line_sets", &Options::with_line_sets},
        style::Field{"with_line_depth", &Options::with_line_depth},
        style::Field{"with_line_vector", &Options::with_line_vector},
        style::Field{"with_line_id", &Options::with_line_id},
        style::Field{"boil_drawing", &Options::boil_drawing, "", "", style::number(0, 1000, 12)},
        style::Field{"matte_ranks", &Options::matte_ranks, "", "", style::number(0, 16, 16)});
};

}  // namespace fovea::draw

namespace fovea::style {
template <>
inline constexpr Choice choices_of<draw::Visibility>[] = {
    {"exact", "Exact", "Rays decide what is hidden"},
    {"atlas", "Fast (Sampled)", "A depth buffer decides what is hidden, at every sample along the lines"},
    {"spine", "Per Pixel (Spine Test)",
     "A depth buffer decides what is hidden while strokes are drawn; ends have no caps"},
    {"item_buffer", "By Number (Item Buffer)",
     "Lines are drawn by number and seen where their number is found: for comparison"},
};
}  // namespace fovea::style
