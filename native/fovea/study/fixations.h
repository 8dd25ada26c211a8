// SPDX-License-Identifier: GPL-3.0-or-later
// Where eyes go, by salience.
#pragma once

#include <fovea/study/plane.h>

namespace fovea::study {

struct Fixation {
    dvec2 at;         ///< in [0, 1] from the left and the bottom of the picture
    double salience;  ///< of the first one's: 1 at the first one
};

/// The most salient place of a picture of this shape (width over height), the most salient one away from it, and so
/// on: the winner takes all, and then a disc around it is inhibited, whose radius is a sixth of the shorter side (Itti,
/// Koch & Niebur 1998). At most `most`; none where nothing stands out.
std::vector<Fixation> fixations(Plane salience, double shape, int most);

/// Share of all salience that lies where `weights` (in [0, 1], of the same picture in any resolution) say; where
/// nothing stands out, their mean.
double salient_share(const Plane& salience, const Plane& weights);

}  // namespace fovea::study
