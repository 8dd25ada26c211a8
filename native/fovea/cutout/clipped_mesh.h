// SPDX-License-Identifier: GPL-3.0-or-later
// The polygons of a mesh, clipped.
#pragma once

#include <optional>

#include <fovea/cutout/clip.h>
#include <fovea/cutout/cutout.h>

namespace fovea::cutout {

/// Numbers of three corners of a polygon.
using Corners = std::array<Index, 3>;

/// A triangle of a polygon of the mesh, clipped.
struct ClippedTriangle {
    Corners corners;
    Clipped clipped;
};

/// Whether a polygon is opaque, or nowhere, or else its triangles.
struct ClippedPolygon {
    Clipped::What what = Clipped::whole;
    std::vector<ClippedTriangle> triangles;
};

struct ClippedMesh {
    std::vector<ClippedPolygon> polygons;
    std::vector<std::optional<Outlines>> outlines;  ///< per cut; none: it clips no polygon

    /// Polygons stay whole whose texture coordinates are not finite, or span more texels than can be followed.
    ClippedMesh(const MeshArrays& mesh, const std::vector<Cut>& cuts, const CutOptions& options);
};

}  // namespace fovea::cutout
