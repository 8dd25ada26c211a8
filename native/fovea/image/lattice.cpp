// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/image/lattice.h>

#include <algorithm>
#include <cmath>

namespace fovea::image {

Lattice lattice_over(const View& view, double step_reference_px, int border) {
    constexpr double most_nodes = 1 << 24;
    constexpr double least_step_px = 1.0 / 8.0;  // pictures of a few pixels do not need the nodes of large ones
    constexpr double farthest = 1e9;             // steps: nodes further from the view axis are not told apart
    Lattice lattice;
    const double room = 1.0 + lattice_margin;
    lattice.step_px = std::max({step_reference_px * view.reference_scale, least_step_px,
                                std::sqrt(room * view.width * room * view.height / most_nodes)});
    const dvec2 axis = to_pixels(view, view.view_to_clip * dvec4(0, 0, -1, 1));
    const auto along = [&](double on_axis, int pixels, double& first, int& count) {
        const double margin = 0.5 * lattice_margin * pixels, step = lattice.step_px;
        if (!(std::abs(on_axis) < farthest * step)) on_axis = 0.0;
        const double low = std::floor((-margin - on_axis) / step) - border;
        count = static_cast<int>(std::ceil((pixels + margin - on_axis) / step) + border - low) + 1;
        first = on_axis + low * step;
    };
    along(axis.x, view.width, lattice.first_px.x, lattice.width);
    along(axis.y, view.height, lattice.first_px.y, lattice.height);
    return lattice;
}

}  // namespace fovea::image
