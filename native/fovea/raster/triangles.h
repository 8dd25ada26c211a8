// SPDX-License-Identifier: GPL-3.0-or-later
// The software rasterizer: triangles projected, cut at the near plane, and drawn row by row.
#pragma once

#include <array>
#include <functional>

#include <fovea/base/parallel.h>
#include <fovea/base/types.h>

namespace fovea::raster {

/// Triangles of one placement, borrowed.
struct RasterMesh {
    In<vec3> positions;        ///< object space
    In<glm::uvec3> triangles;  ///< vertices
    In<Index> triangle_facet;  ///< per triangle, numbered over the mesh
    dmat4 object_to_view{1.0};
    Index facet_base = 0;  ///< added to triangle_facet: numbers over the whole scene
    /// Triangles that turn away from the viewer are left out: on solid bodies others lie before them.
    bool one_sided = false;
};

/// A triangle on the screen, in texels. Corners are in a fixed order per edge when tested, so that two
/// triangles that share an edge leave no texel between them.
struct RasterTriangle {
    std::array<dvec2, 3> corner;
    dvec3 plane;           ///< depth (base/view.h) = plane . (x, y, 1)
    Index mesh, triangle;  ///< which of the meshes, and which triangle of it
    /// Which edges, from each corner to the next, are the mesh's; the near plane's cut is none, as on the GPU.
    std::array<bool, 3> of_mesh;
    int x0, x1, y0, y1;  ///< texels whose centers the bounding box holds, x1 and y1 excluded

    bool covers(dvec2 p) const;
};

/// Which texels a triangle covers, row by row. The triangle is borrowed.
class TriangleRows {
   public:
    explicit TriangleRows(const RasterTriangle& triangle);

    /// Texels of a row, from left to right; `end` is excluded.
    struct Texels {
        int begin, end;
    };
    /// Those whose centers are covered: of a convex shape they lie side by side.
    Texels covered(int y) const;

    double depth(int x, double depth_y) const { return plane_.x * (x + 0.5) + depth_y; }
    /// The part of `depth` that a whole row shares.
    double depth_y(int y) const { return plane_.y * (y + 0.5) + plane_.z; }

   private:
    /// Where the line of an edge crosses the middle of the rows: at + step * y [texels' centers].
    struct Side {
        double at, step;
    };
    const RasterTriangle& triangle_;
    dvec3 plane_;
    std::array<Side, 2> left_, right_;  // without an edge: one that cuts nothing off
    double unsure_ = 0.0;               // centers that lie nearer to an edge are asked for with `covers`
};

/// put(x, depth) for each texel (x, y) that the triangle covers and where in_front(x, depth).
template <typename InFront, typename Put>
void each_texel(const TriangleRows& rows, int y, const InFront& in_front, const Put& put) {
    const double depth_y = rows.depth_y(y);
    const auto [begin, end] = rows.covered(y);
    for (int x = begin; x < end; ++x) {
        const double depth = rows.depth(x, depth_y);
        if (in_front(x, depth)) put(x, depth);
    }
}

/// What triangles are drawn into.
struct RasterTarget {
    int width, height;   ///< texels
    dmat4 view_to_clip;  ///< to (x w, y w, depth w, w), x and y in [-1, 1] over the texels
};

/// Rows of a band; the first band begins at row 0.
inline constexpr int raster_band_rows = 16;

/// draw(triangle, y0, y1) for every triangle that may cover a texel's center in the rows y0 to y1 (excluded):
/// side by side for bands of rows, within each in the order of the meshes. What lies nearer than the near plane
/// is cut off; the far plane cuts nothing off. Triangles without area on the screen or with a coordinate that is not
/// finite are left out. Throws std::invalid_argument on indices out of range.
void draw_triangles(const RasterTarget& target, In<RasterMesh> meshes, const Cancel* cancel,
                    const std::function<void(const RasterTriangle&, int, int)>& draw);

}  // namespace fovea::raster
