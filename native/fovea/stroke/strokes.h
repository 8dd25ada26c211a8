// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of strokes, which every backend draws.
#pragma once

#include <fovea/base/columns.h>

namespace fovea::stroke {

/// Strips of triangles around the center lines of strokes, half a pixel wider than the pen for
/// antialiasing. Triangles of a stroke that touch share corners (or have corners at the very same
/// place), so that a pixel between them is drawn once. Pixels as in View. Everything is affine over
/// a triangle; coverage and ink of a fragment: fragment.h.
struct Strokes {
    Array<vec2> px;
    Array<vec4> arc;
    Array<float> half_width, opacity;
    Array<vec4> mix;
    Array<vec2> anchor;
    Array<Index> pen, piece;
    Array<vec3> color;

    static constexpr auto vertex_columns = each_of(
        Column{"px", &Strokes::px, "(V, 2) float32 corner of the strip, pixels"},
        Column{
            "arc", &Strokes::arc,
            "(V, 4) float32: u [px of arc along the whole path, 0 at its middle], v [px across, positive to the left "
            "of the way], u of the run's start and of its end (-+1e9 where a closed stroke has no ends)"},
        Column{"half_width", &Strokes::half_width,
               "(V,) float32 half the drawn width [px], at least .5: thinner pens are drawn a pixel wide and fainter"},
        Column{"opacity", &Strokes::opacity, "(V,) float32 of strength, thinness and the pens"},
        Column{
            "mix", &Strokes::mix,
            "(V, 4) float32: how far color and ink are those of the pen out of focus, and how far the color is "
            "the pen's second one, each in [0, 1]; and up to how much ink of its texture nothing is left, 0: all is"},
        Column{
            "anchor", &Strokes::anchor,
            "(V, 2) float32, for marks fixed to the path: place on the whole path, from -.5 to .5, and the pixels of "
            "a path that is as large all along as it is here; 0 where no marks are fixed to it"},
        Column{"pen", &Strokes::pen, "(V,) uint32 index of the pen in focus, the same all over a stroke"},
        Column{"piece", &Strokes::piece,
               "(V,) uint32 piece of ClippedPaths that it belongs to; only the spine test asks, and it may be empty "
               "otherwise"},
        Column{"color", &Strokes::color,
               "(V, 3) float32 scene-linear color before the second one, where a pen takes it from surfaces; else it "
               "is empty, and colors are those of the pens"});

    /// Vertices of each triangle, in either winding, in drawing order: stroke by stroke, along each stroke.
    Array<glm::uvec3> triangles;
    /// Strokes that have triangles.
    Index count = 0;
};

}  // namespace fovea::stroke
