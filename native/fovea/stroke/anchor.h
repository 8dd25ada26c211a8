// SPDX-License-Identifier: GPL-3.0-or-later
// Places of marks that are fixed to a path: textures, dashes, wobble.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/project/clipped_paths.h>
#include <fovea/stroke/center_line.h>
#include <fovea/stroke/marks.h>
#include <fovea/stroke/noise.h>

namespace fovea::stroke {

/// Where marks of a piece lie on its path, whichever parts of it are clipped or hidden. On a path that does not depend
/// on the view they are fixed to the surface: by arc length in its rest shape, however the surface turns, bends or
/// grows in the image. On others where Marks are, if these have them; else, and without Paths, by arc length in the
/// image.
class PathAnchor {
   public:
    /// `window_px`: length in the image over which sizes are averaged, so that foreshortening does not crush a mark.
    /// `marks`: null: none.
    PathAnchor(const ClippedPaths& clipped, const Paths* paths, const Marks* marks, Index piece, double window_px);

    /// Sets `along` and `whole_px` of a line's points, and inserts some between which these are linear.
    void place(CenterLine& line) const;

   private:
    double rest_at(double arc) const;
    double mark_at(In<double> values, double arc) const;
    void place(CenterPoint& point) const;
    void place_at_rest(CenterPoint& point) const;
    void place_at_marks(CenterPoint& point) const;

    const ClippedPaths& clipped_;
    const Paths* paths_;  ///< null: not by arc length in the rest shape
    const Marks* marks_;  ///< null: not where Marks are
    Index piece_;
    double window_px_, rest_length_ = 0.0;
};

/// Whether a piece has Marks; `marks` may be null.
inline bool has_marks(const Marks* marks, Index piece) { return marks && marks->of && marks->of->period[piece] > 0.0; }

/// Smooth noise in [-1, 1] at a point, in waves of about `length_px`: fixed to the path where marks are, by two blended
/// octaves as a texture is (shaders/shared/stroke.glsl), else by its arc length in the image.
double noise_along(const CenterPoint& point, double length_px, const Hand& hand);

}  // namespace fovea::stroke
