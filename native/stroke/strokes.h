// Visible runs shaped into triangles: what every backend draws.
#pragma once

#include "base/types.h"

namespace fovea {

/// Strips of triangles around the centre lines of strokes, half a pixel wider than the pen for
/// antialiasing. Triangles of a stroke that touch share corners (or have corners at the very same
/// place), so that a pixel between them is drawn once. Pixels as in View. Everything is affine over
/// a triangle; coverage and ink of a fragment: fragment.h.
struct Strokes {
    /// Per vertex: corner of the strip [px].
    Array<vec2> px;
    /// Per vertex: u [px of arc along the whole path, 0 at its middle], v [px across, positive to
    /// the left of the way], u of the run's start and of its end (-+1e9 where a closed stroke has
    /// no ends).
    Array<vec4> arc;
    /// Per vertex: half the drawn width [px], at least .5: thinner pens are drawn a pixel wide and
    /// fainter.
    Array<float> half_width;
    /// Per vertex: of strength, thinness and the pens.
    Array<float> opacity;
    /// Per vertex: how far color and ink are those of the pen out of focus, each in [0,1].
    Array<vec2> mix;
    /// Per vertex: length of the whole path [px], the same all over a stroke; for textures anchored to it.
    Array<float> path_px;
    /// Per vertex: index of the pen (in focus), the same all over a stroke.
    Array<Index> pen;
    /// Per vertex: piece of ClippedPaths that it belongs to; only the spine test asks, and it may be empty otherwise.
    Array<Index> piece;
    /// Corners of each triangle, either way round, in drawing order: stroke after stroke, along
    /// each stroke.
    Array<glm::uvec3> triangles;
    /// Strokes that have triangles.
    Index count = 0;
};

}  // namespace fovea
