// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of the bands that lines reserve; both backends rasterize them into the priority buffer.
#pragma once

#include <fovea/base/columns.h>
#include <fovea/elision/own_band.h>

namespace fovea::elision {

/// V vertices and T triangles, run by run, the highest rank first. Each side is drawn half a pixel wider than the band,
/// and a pixel's coverage by the band is clamp(h + .5 - |v|, 0, 1) at its center, with v and h affine over the
/// triangle. Bands end square, an eighth of their width before their run does; those of dots half their width beyond
/// it.
struct Bands {
    Array<vec2> px;
    Array<vec3> across, owner;

    static constexpr auto vertex_columns = each_of(
        Column{"px", &Bands::px, "(V, 2) float32 pixels"},
        Column{
            "across", &Bands::across,
            "(V, 3) float32: v: pixels across, positive to the left of the way, h: half the band's width, e: how near "
            "the run's end is, from 0 at OwnBands::reach_px, or half way along the run, to 1 there; negative towards "
            "the start"},
        Column{"owner", &Bands::owner,
               "(V, 3) float32: unit vector to the left of the way, and rank; the same for the corners of a triangle"});

    Array<glm::uvec3> triangles;
};

/// Bands of all runs that own samples. The gap on the outer side of a bend is filled. The width is linear between
/// samples, to 1/20 px. Of bands that are alike (to 1/16 px), those of the 16 highest ranks are drawn. Throws
/// std::invalid_argument for more than 2^23 - 1 ranks. Cole 2009, section 5.2.2.
Bands draw_bands(const ClippedPaths& clipped, const Runs& runs, In<Index> ranks, const OwnBands& own);

}  // namespace fovea::elision
