// SPDX-License-Identifier: GPL-3.0-or-later
// Shading normals: those of the fitted surface, split at hard edges.
#pragma once

#include <memory>

#include <fovea/mesh/surface.h>

namespace fovea::field {

/// Unit normals at the corners of triangles, on the side that the triangle's winding makes the outside. At a vertex
/// without hard edges (field/neighbors.h): the fitted normal. At other vertices: the mean, weighted by angle, of the
/// normals of the triangles there that are within the hard angle of the corner's own. Where neither is defined: the
/// facet normal.
struct CornerNormals {
    Array<vec3> vertex;
    Array<Index> first;  ///< per triangle: index of its three normals in `corner`, or `none` to use those in `vertex`
    Array<vec3> corner;

    vec3 at(const Triangle& vertices, Index triangle, int k) const {
        return first[triangle] == none ? vertex[vertices[k]] : corner[first[triangle] + k];
    }
};

/// Cached with the surface.
std::shared_ptr<const CornerNormals> corner_normals(const Surface& surface);

}  // namespace fovea::field
