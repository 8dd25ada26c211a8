// SPDX-License-Identifier: GPL-3.0-or-later
// Clusters of neighboring, similarly oriented triangles, with bounds on their fields, so that a cluster in which a view
// cannot have a line is rejected without visiting its triangles. Bounding normal cones: Sander et al., "Silhouette
// Clipping", SIGGRAPH 2000.
#pragma once

#include <algorithm>
#include <memory>

#include <fovea/field/fields.h>
#include <fovea/mesh/surface.h>

namespace fovea::field {

inline constexpr Index triangles_of_cluster = 64;

/// Bounds over all vertices of a cluster: means, and spreads (the greatest distance from the mean). Object space;
/// spreads are rounded up.
struct ClusterBounds {
    vec3 center;  ///< of a sphere that contains the vertices
    float radius;
    vec3 normal;
    float normal_spread;
    /// Second fundamental form h on object space, k1 e1 e1^T + k2 e2 e2^T, as (xx, yy, zz), (xy, xz, yz); spread in the
    /// Frobenius norm.
    vec3 form[2];
    float form_spread;
    /// Laplacian of the normal over the surface: (C0 + C2) e1 + (C1 + C3) e2 - (k1^2 + k2^2) n.
    vec3 laplacian;
    float laplacian_spread;
    float curvature;  ///< maximum of |k1|
    float third;      ///< upper bound of C(x, x, x) over unit tangents x
};

/// Partition of the triangles into clusters; all but the last have triangles_of_cluster triangles. Clusters with
/// adjacent numbers are adjacent in space, too.
struct Clusters {
    Array<Index> triangles;  ///< cluster c has [begin(c), end(c)), ascending
    /// Per entry of `triangles`: its vertices, as positions in the cluster's list of vertices.
    Array<glm::u16vec3> corners;
    Lists<Index> vertices;  ///< per cluster, without repetition
    Index count() const { return vertices.count(); }
    Index begin(Index c) const { return c * triangles_of_cluster; }
    Index end(Index c) const { return std::min(begin(c + 1), static_cast<Index>(triangles.size())); }
};

/// Cached with the surface.
std::shared_ptr<const Clusters> clusters_of(const Surface& surface);

/// Two levels of bounds: of clusters, and of groups of `group` consecutive clusters.
struct Hierarchy {
    static constexpr Index group = 16;
    Array<ClusterBounds> clusters, groups;
};

/// Bounds of the fields that the surface's own options give. Cached with the surface, per options.
std::shared_ptr<const Hierarchy> hierarchy_of(const Surface& surface);

}  // namespace fovea::field
