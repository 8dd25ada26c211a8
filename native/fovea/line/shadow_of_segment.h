// SPDX-License-Identifier: GPL-3.0-or-later
// The shadow of a straight segment, as of an edge: where rays of light that pass it meet surfaces.
#pragma once

#include <fovea/line/dark_parts.h>

namespace fovea::line {

/// Ends of a segment in the space of a LightEye, and what rays ignore at it.
struct CastingSegment {
    dvec3 from, to;
    Ignore ignore;
    double reach = 0.0;  ///< on its own body it casts nothing nearer than that
};

/// A straight piece of a shadow on a facet; in the light's space.
struct ShadowPiece {
    Index placement = none, triangle = none;  ///< the triangle is one of the facet
    dvec3 point[2] = {};
    bool goes_on = false;               ///< the next piece begins where this one ends
    bool starts = false, ends = false;  ///< its ends are shadows of the segment's ends
};

/// Appends the shadow of the lit parts of a segment, in their order. It is followed by rays at the eye's steps, where
/// it is not known to be dark; where two neighboring rays meet different facets, to the edge between two triangles, or
/// to 2^-20 of the scene's radius, where it ends, as it falls over an edge or the segment is hidden from the light:
/// there first where what a ray has met ends, then by bisection. `dark`: of this eye, best of neighboring segments
/// before. `rays`: how many may be asked, less those that are; without any left, the segment casts nothing more.
void append_shadow(const LightEye& eye, DarkParts& dark, const CastingSegment& segment, std::size_t& rays,
                   Array<ShadowPiece>& out);

}  // namespace fovea::line
