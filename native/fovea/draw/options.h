// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of the method that are not the style's.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <fovea/style/field.h>

namespace fovea::draw {

/// How it is decided what is hidden.
enum class Visibility : std::uint8_t {
    exact,       ///< rays: the same answer on every machine (visibility/exact.h)
    atlas,       ///< looks into a depth buffer at every sample along the lines (visibility/sampled.h)
    spine,       ///< at every pixel of a stroke (visibility/spine.h)
    item_buffer  ///< lines drawn by number against a depth buffer (visibility/item_buffer.h)
};

/// Line definitions by name that, of a line set, draw only what is the outer boundary of its object.
using Outlines = std::vector<std::pair<int, std::vector<std::string>>>;

struct Options {
    Visibility visibility = Visibility::exact;
    double sample_step = 2.0;    ///< reference pixels between visibility samples
    int depth_scale = 2;         ///< texels of the depth buffer per pixel, along each axis
    int probes = 9;              ///< looks into the depth buffer per sample
    int layers = 3;              ///< lines that a texel of the item buffer holds
    double gap = 3.0;            ///< reference pixels of hidden line that are drawn over; more than one sample
    double spur = 1.0;           ///< reference pixels of visible line that are left out
    double contour_spur = 10.0;  ///< the same inside contours, which break up where they end on a smooth surface
    double fold = 30.0;          ///< reference pixels up to which a contour's end may fold back and is cut off
    double meet = 8.0;          ///< reference pixels that a contour is drawn on over facets of its own, to another line
    double beside = 4.0;        ///< reference pixels to a visible line at which a hidden one along it is left out
    double least_hidden = 6.0;  ///< reference pixels; shorter hidden parts between visible ones are left out
    /// Drafts: what of a line set's lines is not the outer boundary goes to the next set that wants it. Hidden parts
    /// have no pens then.
    Outlines outlines = {};
    int focus_step = 1;       ///< drafts: pixels between those whose focus is evaluated for the colors under the lines
    bool with_depth = false;  ///< also make the depth pass
    bool with_focus = false;  ///< and that of focus, where the style has one

    bool operator==(const Options&) const = default;

    static constexpr std::tuple fields{style::Field{"visibility", &Options::visibility},
                                       style::Field{"sample_step", &Options::sample_step},
                                       style::Field{"depth_scale", &Options::depth_scale},
                                       style::Field{"probes", &Options::probes},
                                       style::Field{"layers", &Options::layers},
                                       style::Field{"gap", &Options::gap},
                                       style::Field{"spur", &Options::spur},
                                       style::Field{"contour_spur", &Options::contour_spur},
                                       style::Field{"fold", &Options::fold},
                                       style::Field{"meet", &Options::meet},
                                       style::Field{"beside", &Options::beside},
                                       style::Field{"least_hidden", &Options::least_hidden},
                                       style::Field{"outlines", &Options::outlines},
                                       style::Field{"focus_step", &Options::focus_step},
                                       style::Field{"with_depth", &Options::with_depth},
                                       style::Field{"with_focus", &Options::with_focus}};
};

}  // namespace fovea::draw

namespace fovea::style {
template <>
inline constexpr Choice choices_of<draw::Visibility>[] = {{"exact"}, {"atlas"}, {"spine"}, {"item_buffer"}};
}  // namespace fovea::style
