// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/project/piece_arcs.h>

#include <fovea/base/view.h>

namespace fovea::project {

double PieceArcs::in_space(double px) const {
    const Index i = clipped_.segment_at(piece_, px);
    const double share = share_in_space(clipped_.share_at(i, px), distance(i), distance(i + 1));
    return glm::mix(at_point(i), at_point(i + 1), share);
}

double PieceArcs::in_image(double arc) const {
    Index low = clipped_.pieces.begin(piece_), high = clipped_.pieces.end(piece_) - 1;
    while (high - low > 1) {
        const Index middle = low + (high - low) / 2;
        (at_point(middle) <= arc ? low : high) = middle;
    }
    const double from = at_point(low), length = at_point(high) - from;
    const double share = length > 0.0 ? std::clamp((arc - from) / length, 0.0, 1.0) : 0.0;
    return glm::mix(clipped_.arc_px[low], clipped_.arc_px[high], share_in_space(share, distance(high), distance(low)));
}

double PieceArcs::at_point(Index point) const {
    const double here = paths_.arc_obj[clipped_.source[point]], t = clipped_.source_t[point];
    // The last point of a path has no next point.
    return t > 0.0 ? glm::mix(here, paths_.arc_obj[clipped_.source[point] + 1], t) : here;
}

}  // namespace fovea::project
