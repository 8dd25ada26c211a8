// SPDX-License-Identifier: GPL-3.0-or-later
// Arc lengths of a piece in the image, and those of its path in space.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/project/clipped_paths.h>

namespace fovea::project {

/// Turns places of one piece, of two points or more, from one to the other; beyond its ends they are its ends.
class PieceArcs {
   public:
    /// Borrows.
    PieceArcs(const ClippedPaths& clipped, const Paths& paths, Index piece)
        : clipped_(clipped), paths_(paths), piece_(piece) {}

    /// Paths::arc_obj at ClippedPaths::arc_px.
    double in_space(double px) const;
    /// The other way around.
    double in_image(double arc) const;

   private:
    double at_point(Index point) const;
    double distance(Index point) const {
        return clipped_.orthographic ? 1.0 : -double(clipped_.position_view[point].z);
    }

    const ClippedPaths& clipped_;
    const Paths& paths_;
    Index piece_;
};

}  // namespace fovea::project
