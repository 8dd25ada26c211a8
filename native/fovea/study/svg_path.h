// SPDX-License-Identifier: GPL-3.0-or-later
// Paths of SVG files as pixels.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fovea/study/bitmap.h>
#include <fovea/vector/curve.h>

namespace fovea::study {

/// A path of an SVG file. Its transform is that of SVG, x' = a x + c y + e, y' = b x + d y + f, to pixels from the
/// upper left corner.
struct SvgPath {
    std::string data;  ///< its attribute `d`
    std::array<double, 6> transform;
    bool is_filled;  ///< an area, else a line
};

/// The subpaths of path data (SVG 1.1, section 8.3), up to the first error, as SVG asks for.
std::vector<vector::Curve> curves_of(std::string_view data);

/// The paths as pixels: lines where they run, areas as the lines in their middle.
Bitmap pixels_of_svg(const std::vector<SvgPath>& paths, int width, int height);

}  // namespace fovea::study
