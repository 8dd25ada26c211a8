// SPDX-License-Identifier: GPL-3.0-or-later
// The frame and the title block of a sheet of paper. ISO 7200:2004 has the data fields and the width of the block,
// ISO 5457 its place and the frame, ISO 128 the widths of lines, ISO 3098 the heights of letters.
#pragma once

#include <vector>

#include <fovea/base/view.h>
#include <fovea/vector/document.h>
#include <fovea/vector/options.h>
#include <fovea/vector/page.h>

namespace fovea::vector {

/// A cell of a title block. Lengths in millimeters.
struct TitleCell {
    std::string name, label, text;
    dvec2 lower, size;
    double letters;  ///< height of the text's capital letters
};

/// Width and height of the title block in the lower right corner of a drawing space, that in the frame [mm]. Throws
/// std::invalid_argument where that is too narrow for it, or leaves no room above it.
dvec2 title_block_size(const dvec2& space);

/// The cells of a title block whose lower left corner is given, row by row from above; together they cover it.
/// `scale`: see scale_text.
std::vector<TitleCell> title_cells(const dvec2& lower, double width, const Options& options, const std::string& scale);

/// N:1 or 1:N of a picture on a page, with four digits; of a perspective view, or of pixels that are not square, that
/// it has none. `unit_meters`: of a unit of the scene.
std::string scale_text(const View& view, const Page& page, double unit_meters);

/// A line of text that is at most so wide [mm], for letters as wide as those of wide sans serif fonts: with capital
/// letters of the height `letters`, or lower ones of at least least_letters, or else its beginning and an ellipsis.
/// Without an id and a place.
Caption fitted(const std::string& text, double letters, double width);
inline constexpr double least_letters = 1.8;  ///< the smallest height of ISO 3098

/// Two layers: thick lines around the drawing space and the block; thin lines between its cells, and its text, which is
/// left out for a plotter. `ink`: of both, as displayed.
std::vector<Layer> title_block_layers(const Page& page, const Options& options, const std::string& scale,
                                      const dvec3& ink);

}  // namespace fovea::vector
