// SPDX-License-Identifier: GPL-3.0-or-later
// Normals to shade with: those of the fitted surface, and beside hard edges those of each smooth side.
#pragma once

#include <memory>

#include <fovea/mesh/surface.h>

namespace fovea::field {

/// Unit normals at the corners of triangles, on the side that the triangle's winding calls out. At a vertex without
/// hard edges (field/neighbors.h) the fitted normal; at others the mean, by angle, of the triangles there that are
/// within the hard angle of the corner's own. A corner of which nothing is known has the normal of its facet.
struct CornerNormals {
    Array<vec3> vertex;
    Array<Index> first;  ///< per triangle: where its three normals begin in `corner`; `none`: those of `vertex` serve
    Array<vec3> corner;

    vec3 at(const Triangle& vertices, Index triangle, int k) const {
        return first[triangle] == none ? vertex[vertices[k]] : corner[first[triangle] + k];
    }
};

/// Kept with the surface.
std::shared_ptr<const CornerNormals> corner_normals(const Surface& surface);

}  // namespace fovea::field
