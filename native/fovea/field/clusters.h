// SPDX-License-Identifier: GPL-3.0-or-later
// Clusters of triangles that lie together and face alike, with bounds on their fields: what no view can see in a
// cluster need not be looked for in its triangles. Normal cones: Sander et al., "Silhouette Clipping", SIGGRAPH 2000.
#pragma once

#include <algorithm>
#include <memory>

#include <fovea/field/fields.h>
#include <fovea/mesh/surface.h>

namespace fovea::field {

inline constexpr Index triangles_of_cluster = 64;

/// Of all vertices of a cluster. A spread is the greatest distance from the middle. Object space, rounded up.
struct ClusterBounds {
    vec3 center;  ///< of a sphere that holds the vertices
    float radius;
    vec3 normal;
    float normal_spread;
    /// The form h on object space, k1 e1 e1^T + k2 e2 e2^T, as xx, yy, zz, xy, xz, yz; spread in the Frobenius norm.
    vec3 form[2];
    float form_spread;
    /// Laplacian of the normal over the surface: (C0 + C2) e1 + (C1 + C3) e2 - (k1^2 + k2^2) n.
    vec3 laplacian;
    float laplacian_spread;
    float curvature;  ///< greatest |k1|
    float third;      ///< C(x, x, x) of no unit tangent x is greater
};

/// Every triangle is in one cluster; only the last is smaller than the others. Neighbors in number lie together, too.
struct Clusters {
    Array<Index> triangles;       ///< cluster c has those from c * triangles_of_cluster on, ascending
    Array<glm::u16vec3> corners;  ///< per entry of `triangles`: its vertices, as places in the cluster's row
    Lists<Index> vertices;        ///< per cluster, each once
    Index count() const { return vertices.count(); }
    Index begin(Index c) const { return c * triangles_of_cluster; }
    Index end(Index c) const { return std::min(begin(c + 1), static_cast<Index>(triangles.size())); }
};

/// Kept with the surface.
std::shared_ptr<const Clusters> clusters_of(const Surface& surface);

/// Two levels of bounds: of clusters, and of groups of so many that follow one another.
struct Hierarchy {
    static constexpr Index group = 16;
    Array<ClusterBounds> clusters, groups;
};

/// Of the surface's own fields. Kept with the surface, by its options.
std::shared_ptr<const Hierarchy> hierarchy_of(const Surface& surface);

}  // namespace fovea::field
