// SPDX-License-Identifier: GPL-3.0-or-later
// Lattice of sample points in the image, fixed to the camera.
#pragma once

#include <fovea/base/view.h>

namespace fovea::image {

/// Margin around the frame, as a share of its half size, in which lines are traced: the same as that of paths.
inline constexpr double lattice_margin = 0.1;

/// Square lattice, stored row by row from the lower left. Its nodes are placed relative to the image of the view axis,
/// in reference pixels, so that a render border, a crop or a preview of another size, as long as the step need not be
/// increased (lattice_over), uses the same nodes and shows the same lines.
struct Lattice {
    dvec2 first_px{0.0};  ///< node (0, 0), in pixels of the view
    double step_px = 1.0;
    int width = 0, height = 0;

    std::size_t size() const { return std::size_t(width) * height; }
    std::size_t at(int x, int y) const { return std::size_t(y) * width + x; }
    dvec2 px(const dvec2& node) const { return first_px + step_px * node; }
};

/// One value per node.
using Buffer = Array<float>;

/// Sample i of 2^bits in the square of a node or pixel, relative to its middle: the Hammersley set in base 2, a
/// (0, bits, 2)-net; low-discrepancy, so equally accurate for edges of any slope.
inline dvec2 place_in_square(int i, int bits) {
    int reversed = 0;
    for (int bit = 0; bit < bits; ++bit) reversed |= (i >> bit & 1) << (bits - 1 - bit);
    return dvec2(i + 0.5, reversed + 0.5) / double(1 << bits) - 0.5;
}

/// Lattice over the frame, its margin and `border` more steps on each side. The step is increased where there would be
/// more than about 2^24 nodes, or 8 to a pixel along each axis.
Lattice lattice_over(const View& view, double step_reference_px, int border);

}  // namespace fovea::image
